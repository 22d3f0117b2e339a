#include "statics/recovery_stress.h"

#include <algorithm>
#include <cmath>

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

/// A section of pipe on its way from the tensioner.
class Traveller {
 public:
  explicit Traveller(LayHistory history) : history_(history) {}

  /// A section that has been there before, with what it remembers.
  void is_at(const Section& section, const BendingMemory& memory) {
    memory_ = memory;
    section_ = &section;
    known_ = true;
  }

  void bend_to(const Section& section, StationCut& at) {
    if (!known_ && (&section != section_ || history_ == LayHistory::monotonic)) {
      memory_ = fresh_memory(at.tangent);
      section_ = &section;
    }
    bring_along(memory_, at.tangent);
    const LevelMix mix = level_at(*section.bending, at.station.p_W.z());
    const Vec2 moment = in_axes(memory_, at.bend);
    at.station.curvature = curvature_for(*section.bending, mix, section.EI, moment, memory_).norm();
    at.station.residual_curvature = residual_curvature(*section.bending, mix, section.EI, memory_).norm();
  }
  double largest_curvature() const { return memory_.largest; }

 private:
  LayHistory history_;
  const Section* section_ = nullptr;
  bool known_ = false;
  BendingMemory memory_;
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
  Traveller traveller(model.description.statics.history);
  std::vector<Station> stations(cuts.size());
  for (std::size_t i = cuts.size(); i-- > 0;) {
    StationCut& at = cuts[i];
    const Section& section = model.sections[static_cast<std::size_t>(at.section)];
    if (section.kind == SectionKind::cable) {
      lay_straight(at);
      stations[i] = at.station;
      continue;
    }
    at.station.curvature = at.station.bending_moment / section.EI;
    if (section.bending && !memory.empty()) {
      traveller.is_at(section, memory[nearest_gauss_point(mesh, at.station.s)]);
    }
    if (section.bending) traveller.bend_to(section, at);
    set_stress(model, section, section.bending ? traveller.largest_curvature() : 0.0, at.station);
    stations[i] = at.station;
  }
  return stations;
}

}  // namespace overbend
