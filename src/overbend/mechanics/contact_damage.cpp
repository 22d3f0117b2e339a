#include "mechanics/contact_damage.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace overbend {

double dent_depth(double force, double steel_diameter, double wall_thickness, double yield_stress) {
  const double plastic_moment = 0.25 * yield_stress * wall_thickness * wall_thickness;  // of the wall, per length
  // F = dE/d(depth) with E = 16 sqrt(2 pi/9) m_p sqrt(D/t) D (depth/D)^(3/2), [dnvf107]
  const double full =
      24.0 * std::sqrt(2.0 * std::numbers::pi / 9.0) * plastic_moment * std::sqrt(steel_diameter / wall_thickness);
  const double share = std::max(force, 0.0) / full;
  return steel_diameter * share * share;
}

double dent_depth(double force, const Section& section) {
  if (section.yield_stress <= 0.0) return 0.0;
  return dent_depth(force, section.steel_diameter, section.wall_thickness, section.yield_stress);
}

double line_load(double force, double contact_length) {
  return contact_length > 0.0 ? std::max(force, 0.0) / contact_length : 0.0;
}

}  // namespace overbend
