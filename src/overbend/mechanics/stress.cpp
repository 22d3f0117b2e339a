#include "mechanics/stress.h"

namespace overbend {

SectionStress section_stress(const Section& section, const SectionLoads& loads) {
  const SectionWall wall(section);
  if (!section.bending) {
    return stress_of_wall(wall, loads, 0.0, [](double stress, double) { return stress; });
  }
  const BendingLaw& law = *section.bending;
  // The neutral axis moves in bending under tension.
  const double moved_axis = axis_strain(law, level_at(law, loads.z), std::max(loads.curvature, loads.max_curvature));
  return stress_of_wall(wall, loads, moved_axis, [&](double stress, double strain) {
    if (!law.steel) return stress;
    const double yield_limit = law.steel->at(std::abs(strain)).stress;
    return std::clamp(stress, -yield_limit, yield_limit);
  });
}

}  // namespace overbend
