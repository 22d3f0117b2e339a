#include "mechanics/point_load.h"

#include <algorithm>
#include <cmath>

#include "mechanics/ground.h"
#include "mechanics/soil_law.h"

namespace overbend {
namespace {

/// Returns the axial friction along the seabed, positive away from the vessel: of a dragged line, else of one that
/// would slide downhill.
double axial_friction(const PointLoad& load, const LineEnvironment& env, double submerged_weight, double drag,
                      double rise) {
  if (env.dragged) return drag * load.seabed_normal;
  const double limit = env.bed_friction_axial * load.seabed_normal;
  return std::clamp(load.penetration > 0.0 ? submerged_weight * rise : 0.0, -limit, limit);
}

void add_seabed(PointLoad& load, const LineEnvironment& env, double radius, double submerged_weight, double drag,
                const Vec3& r) {
  const GroundPoint ground = ground_at(env, r);
  load.penetration = std::max(0.0, radius - ground.clearance);
  load.seabed_normal = soil_force(env, load.penetration);
  const double limit = env.bed_friction_lateral * load.seabed_normal;
  const double stick = load.penetration > 0.0 ? -env.bed_stick * ground.off_route : 0.0;
  load.seabed = load.seabed_normal * ground.normal + std::clamp(stick, -limit, limit) * ground.across_route +
                axial_friction(load, env, submerged_weight, drag, ground.along_route.z()) * ground.along_route;
}

}  // namespace

Vec3 current_velocity(const LineEnvironment& env, double z) {
  const int n = env.current_rows;
  if (n == 0) {
    return Vec3::Zero();
  }
  const double* above = std::lower_bound(env.current_z, env.current_z + n, z);
  const int i = std::clamp(static_cast<int>(above - env.current_z), 1, std::max(n - 1, 1));
  const int j = std::min(i, n - 1);
  const double dz = env.current_z[j] - env.current_z[i - 1];
  const double f = dz > 0.0 ? std::clamp((z - env.current_z[i - 1]) / dz, 0.0, 1.0) : 0.0;
  const double x = (1.0 - f) * env.current_vx[i - 1] + f * env.current_vx[j];
  const double y = (1.0 - f) * env.current_vy[i - 1] + f * env.current_vy[j];
  return env.current_scale * Vec3(x, y, 0.0);
}

Vec3 current_slope(const LineEnvironment& env, double z) {
  for (int i = 0; i + 1 < env.current_rows; ++i) {
    const double below = env.current_z[i], above = env.current_z[i + 1];
    if (z > below && z < above) {
      const double scale = env.current_scale / (above - below);
      return scale * Vec3(env.current_vx[i + 1] - env.current_vx[i], env.current_vy[i + 1] - env.current_vy[i], 0.0);
    }
  }
  return Vec3::Zero();
}

PointLoad point_load(const LineElements& elements, const LineEnvironment& env, int element, const Vec3& r,
                     const Vec3& a) {
  const std::size_t e = static_cast<std::size_t>(element);
  PointLoad load;
  const double wet = wetted_fraction(r.z(), elements.radius[e]).value;
  load.weight = -elements.weight[e] * Vec3::UnitZ();
  load.buoyancy = elements.buoyancy[e] * wet * Vec3::UnitZ();
  add_seabed(load, env, elements.radius[e], elements.weight[e] - elements.buoyancy[e], elements.drag_on_bed[e], r);
  const Vec3 u = current_velocity(env, r.z());
  const Vec3 t = a.normalized();
  const double along = u.dot(t);
  const Vec3 across = u - along * t;
  load.current =
      wet * (elements.drag_normal[e] * across.norm() * across + elements.drag_axial[e] * std::abs(along) * along * t);
  return load;
}

}  // namespace overbend
