#include "statics/recovery/recovery_stress.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "mechanics/plastic_bending.h"
#include "mechanics/quadrature.h"
#include "mechanics/stress.h"

namespace overbend {
namespace {

void set_stress(const Model& model, const Section& section, double largest_curvature, Station& station) {
  SectionLoads loads;
  loads.effective_tension = station.effective_tension;
  loads.bending_moment = station.bending_moment;
  loads.curvature = station.curvature;
  loads.largest_curvature = largest_curvature;
  loads.z = station.p_W.z();
  loads.external_pressure = model.water_weight_density * std::max(-loads.z, 0.0);
  loads.internal_pressure = section.internal_pressure - section.contents_weight_density * loads.z;
  const SectionStress stress = section_stress(section, loads);
  station.wall_tension = stress.wall_tension;
  station.axial_stress = stress.axial;
  station.bending_stress = stress.bending;
  station.hoop_stress = stress.hoop;
  station.von_mises = stress.von_mises;
  station.strain = stress.strain;
  station.yield_stress = section.yield_stress;
}

/// What is told of a cable is its tension: its moment is that of the little stiffness that keeps it defined, and the
/// stresses of a pipe's wall it does not have.
void lay_straight(StationCut& at) {
  at.station.bending_moment = at.station.vertical_moment = at.station.lateral_moment = 0.0;
  at.station.wall_tension = at.station.effective_tension;
  at.bend = Vec3::Zero();
}

/// Pipe of every section on its way from the tensioner, bent by every place that it has passed, whatever lies there
/// now.
class Travellers {
 public:
  explicit Travellers(const Model& model) : model_(&model), on_way_(model.sections.size()) {}

  /// Pipe that has been there before, with what it remembers.
  void is_at(std::size_t section, const BendingMemory& memory) {
    on_way_[section] = memory;
    known_ = true;
  }

  /// At a place of linear steel.
  void pass(const Section& section, const StationCut& at) {
    if (known_ || model_->description.statics.history != LayHistory::laying) return;
    pass_others(on_way_.size(), at, at.bend / section.EI);
  }

  /// Returns the largest curvature at which the pipe there has yielded [1/m].
  double bend_to(std::size_t index, StationCut& at) {
    const Section& section = model_->sections[index];
    const bool laying = model_->description.statics.history == LayHistory::laying;
    if (!known_ && !laying) on_way_[index].reset();
    BendingMemory& memory = arrived(index, at.tangent);
    const LevelMix mix = level_at(*section.bending, at.station.p_W.z());
    const Vec2 curvature = curvature_for(*section.bending, mix, section.EI, in_axes(memory, at.bend), memory);
    at.station.curvature = curvature.norm();
    at.station.residual_curvature = residual_curvature(*section.bending, mix, section.EI, memory).norm();
    if (!known_ && laying) pass_others(index, at, from_axes(memory, curvature));
    return memory.largest;
  }

 private:
  BendingMemory& arrived(std::size_t index, const Vec3& tangent) {
    std::optional<BendingMemory>& memory = on_way_[index];
    if (!memory) memory = fresh_memory(tangent);
    bring_along(*memory, tangent);
    return *memory;
  }
  void pass_others(std::size_t index, const StationCut& at, const Vec3& curvature) {
    for (std::size_t other = 0; other < on_way_.size(); ++other) {
      const std::optional<BendingLaw>& law = model_->sections[other].bending;
      if (other == index || !law) continue;
      BendingMemory& memory = arrived(other, at.tangent);
      bend(*law, level_at(*law, at.station.p_W.z()), in_axes(memory, curvature), memory);
    }
  }

  const Model* model_;
  std::vector<std::optional<BendingMemory>> on_way_;  ///< By section; none has set out yet.
  bool known_ = false;
};

}  // namespace

namespace {

/// Index of the Gauss point nearest to a station.
std::size_t nearest_gauss_point(const LineMesh& mesh, double s) {
  const auto after = std::upper_bound(mesh.s.begin(), mesh.s.end(), s);
  const std::ptrdiff_t last = mesh.elements() - 1;
  const std::size_t e = static_cast<std::size_t>(std::clamp<std::ptrdiff_t>(after - mesh.s.begin() - 1, 0, last));
  const double xi = (s - mesh.s[e]) / mesh.length[e];
  const auto nearer = [&](double a, double b) { return std::abs(a - xi) < std::abs(b - xi); };
  const std::ptrdiff_t i = std::min_element(kGaussXi, kGaussXi + kGaussPoints, nearer) - kGaussXi;
  return kGaussPoints * e + static_cast<std::size_t>(i);
}

}  // namespace

std::vector<Station> finish_stations(const Model& model, std::vector<StationCut> cuts, const LineMesh& mesh,
                                     const std::vector<BendingMemory>& memory) {
  Travellers travellers(model);
  std::vector<Station> stations(cuts.size());
  for (std::size_t i = cuts.size(); i-- > 0;) {
    StationCut& at = cuts[i];
    const std::size_t index = static_cast<std::size_t>(at.section);
    const Section& section = model.sections[index];
    if (section.kind == SectionKind::cable) {
      lay_straight(at);
      stations[i] = at.station;
      continue;
    }
    at.station.curvature = at.station.bending_moment / section.EI;
    if (section.bending && !memory.empty()) {
      travellers.is_at(index, memory[nearest_gauss_point(mesh, at.station.s)]);
    }
    const double yielded = section.bending ? travellers.bend_to(index, at) : 0.0;
    if (!section.bending && section.kind == SectionKind::pipe) travellers.pass(section, at);
    set_stress(model, section, yielded, at.station);
    stations[i] = at.station;
  }
  return stations;
}

}  // namespace overbend
