#include "hull/hull_wind.h"

#include "hull/body_kinematics.h"

namespace overbend {

Vec6 wind_force(const HullWind& wind, double psi) {
  const Vec3 air = turned_about_z(-psi) * Vec3(wind.velocity.x(), wind.velocity.y(), 0.0);
  if (!wind.table.rows.empty()) {
    return about_reference(flow_on_table(wind.table, wind.density, air.head<2>()).force, wind.reference_V);
  }
  Vec6 total = Vec6::Zero();
  for (const WindAreaDescription& area : wind.areas) {
    const double size = 0.5 * wind.density * air.norm() * area.shape * area.height * area.area;
    const Vec3 force = area.frontal ? Vec3(size * air.x(), 0.0, 0.0) : Vec3(0.0, size * air.y(), 0.0);
    total.head<3>() += force;
    total.tail<3>() += (area.centre - wind.reference_V).cross(force);
  }
  return total;
}

}  // namespace overbend
