#include "dynamics/setup/initial_seabed_friction.h"

#include <algorithm>

#include "mechanics/ground.h"
#include "mechanics/quadrature.h"
#include "mechanics/rod_element.h"
#include "mechanics/soil_law.h"

namespace overbend {
namespace {

/// Elastic stretch of the seabed friction at a point under the static forces: across and along the route.
struct StaticStretch {
  double across, along;
};

StaticStretch static_stretch(const LineEnvironment& env, const Vec3& r, double radius, double submerged_weight) {
  const GroundPoint ground = ground_at(env, r);
  const double force = soil_force(env, std::max(0.0, radius - ground.clearance));
  if (force <= 0.0 || env.bed_stick <= 0.0) {
    return {0.0, 0.0};
  }
  const double limit_across = env.bed_friction_lateral * force / env.bed_stick;
  const double limit_along = env.bed_friction_axial * force / env.bed_stick;
  const double pull = submerged_weight * ground.along_route.z() / env.bed_stick;
  return {std::clamp(ground.off_route, -limit_across, limit_across), -std::clamp(pull, -limit_along, limit_along)};
}

}  // namespace

void set_initial_seabed_friction(const Line& line, LineState& state) {
  const std::size_t padded = line.elements.padded();
  for (int e = 0; e < line.elements.count; ++e) {
    const std::size_t i = static_cast<std::size_t>(e);
    const ElementVector q(Eigen::Map<const ElementVector>(state.q.data() + 6 * e));
    for (int point = 0; point < kGaussPoints; ++point) {
      const Vec3 r = centreline(q, kGaussXi[point], line.mesh.length[i]).r;
      const StaticStretch stretch = static_stretch(line.environment, r, line.elements.radius[i],
                                                   line.elements.weight[i] - line.elements.buoyancy[i]);
      const std::size_t index = static_cast<std::size_t>(point * kBedDirections) * padded + i;
      state.bed_slip[index] = stretch.across;
      state.bed_slip[index + padded] = stretch.along;
    }
  }
}

}  // namespace overbend
