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

void set_stress(const Model& model, const Section& section, double max_curvature, Station& station) {
  SectionLoads loads;
  loads.effective_tension = station.effective_tension;
  loads.bending_moment = station.bending_moment;
  loads.curvature = station.curvature;
  loads.max_curvature = max_curvature;
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

/// Sets moments to zero and the wall tension of a cable: only its tension is reported. Its moment is that of the small
/// stiffness that keeps it defined, and it has no wall stresses of a pipe.
void clear_moments(StationCut& cut) {
  cut.station.bending_moment = cut.station.vertical_moment = cut.station.lateral_moment = 0.0;
  cut.station.wall_tension = cut.station.effective_tension;
  cut.bend = Vec3::Zero();
}

/// Pipe of every section on its way from the tensioner, bent at each place it has passed, independently of the section
/// there now.
class TravellingPipe {
 public:
  explicit TravellingPipe(const Model& model) : model_(&model), memories_(model.sections.size()) {}

  /// Sets the memory of pipe with a known history.
  void set_memory(std::size_t section, const BendingMemory& memory) {
    memories_[section] = memory;
    known_ = true;
  }

  /// Passes a place of linear steel.
  void pass(const Section& section, const StationCut& cut) {
    if (known_ || model_->description.statics.history != LayHistory::laying) return;
    pass_others(memories_.size(), cut, cut.bend / section.EI);
  }

  /// Returns the maximum curvature at which the pipe there has yielded [1/m].
  double bend_to(std::size_t index, StationCut& cut) {
    const Section& section = model_->sections[index];
    const bool laying = model_->description.statics.history == LayHistory::laying;
    if (!known_ && !laying) memories_[index].reset();
    BendingMemory& memory = arrived(index, cut.tangent);
    const LevelMix mix = level_at(*section.bending, cut.station.p_W.z());
    const Vec2 curvature = find_curvature(*section.bending, mix, section.EI, in_axes(memory, cut.bend), memory);
    cut.station.curvature = curvature.norm();
    cut.station.residual_curvature = residual_curvature(*section.bending, mix, section.EI, memory).norm();
    if (!known_ && laying) pass_others(index, cut, from_axes(memory, curvature));
    return memory.max_curvature;
  }

 private:
  BendingMemory& arrived(std::size_t index, const Vec3& tangent) {
    std::optional<BendingMemory>& memory = memories_[index];
    if (!memory) memory = make_bending_memory(tangent);
    transport_axes(*memory, tangent);
    return *memory;
  }
  void pass_others(std::size_t index, const StationCut& cut, const Vec3& curvature) {
    for (std::size_t other_index = 0; other_index < memories_.size(); ++other_index) {
      const std::optional<BendingLaw>& law = model_->sections[other_index].bending;
      if (other_index == index || !law) continue;
      BendingMemory& memory = arrived(other_index, cut.tangent);
      bend(*law, level_at(*law, cut.station.p_W.z()), in_axes(memory, curvature), memory);
    }
  }

  const Model* model_;
  std::vector<std::optional<BendingMemory>> memories_;  ///< Per section; empty until it has started.
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
  TravellingPipe travellers(model);
  std::vector<Station> stations(cuts.size());
  for (std::size_t i = cuts.size(); i-- > 0;) {
    StationCut& cut = cuts[i];
    const std::size_t index = static_cast<std::size_t>(cut.section);
    const Section& section = model.sections[index];
    if (section.kind == SectionKind::cable) {
      clear_moments(cut);
      stations[i] = cut.station;
      continue;
    }
    cut.station.curvature = cut.station.bending_moment / section.EI;
    if (section.bending && !memory.empty()) {
      travellers.set_memory(index, memory[nearest_gauss_point(mesh, cut.station.s)]);
    }
    const double yielded = section.bending ? travellers.bend_to(index, cut) : 0.0;
    if (!section.bending && section.kind == SectionKind::pipe) travellers.pass(section, cut);
    set_stress(model, section, yielded, cut.station);
    stations[i] = cut.station;
  }
  return stations;
}

}  // namespace overbend
