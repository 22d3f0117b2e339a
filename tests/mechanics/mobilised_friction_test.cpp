#include "mechanics/mobilised_friction.h"

#include <gtest/gtest.h>

#include "support/fixtures.h"

namespace overbend {
namespace {

/// Minus the forces of full friction on the nodes of the element, with the normal force k (R - d), from the geometry
/// alone.
ElementVector friction_on(const PlacedRoller& roller, const ElementVector& q, double h, const MobilisedFriction& mu,
                          double reach) {
  const ClosestPoint closest = closest_point(roller, q.data(), &h, 0, 1);
  EXPECT_TRUE(closest.found);
  const RollerDistance distance = roller_distance(roller, closest);
  const CentrelinePoint point = centreline(q, closest.xi, h);
  const HermiteValues n = hermite(closest.xi, h);
  const double normal = roller.stiffness * (reach - distance.value);
  const Vec3 t = point.a.normalized();
  const Vec3 f = normal * (mu.along * t + mu.across * distance.direction.cross(t));
  ElementVector out;
  for (int j = 0; j < 4; ++j) out.segment<3>(3 * j) = -n.value(j) * f;
  return out;
}

TEST(roller_rub, tangent_is_the_derivative_of_the_force) {
  const double h = 2.0, reach = 0.48;
  const PlacedRoller roller{Vec3(1.1, 0.05, -0.4), Vec3(0.1, 0.99, 0.15).normalized(), Vec3::UnitZ(), 0.6, 0.1, 1e6};
  ElementVector q;
  q << 0.0, 0.02, 0.01, 1.02, 0.1, 0.15, 2.0, 0.1, -0.02, 0.98, -0.05, -0.2;
  const MobilisedFriction mu{0.3, -0.2};
  const ClosestPoint closest = closest_point(roller, q.data(), &h, 0, 1);
  const RollerDistance distance = roller_distance(roller, closest);
  const RollerDistanceDerivatives d = roller_distance_derivatives(roller, closest, distance, q, h);
  const MobilisedFrictionForce force{mu.along, mu.across, roller.stiffness * (reach - distance.value),
                                     roller.stiffness};
  ASSERT_GT(force.normal, 1e3);
  const ElementMatrix exact = mobilised_friction_tangent(roller, closest, distance, d, q, h, force);
  const double step = 1e-6, max_value = exact.cwiseAbs().maxCoeff();
  for (int j = 0; j < 12; ++j) {
    ElementVector up = q, down = q;
    up(j) += step;
    down(j) -= step;
    const ElementVector difference =
        (friction_on(roller, up, h, mu, reach) - friction_on(roller, down, h, mu, reach)) / (2.0 * step);
    EXPECT_LT((exact.col(j) - difference).cwiseAbs().maxCoeff(), 1e-6 * max_value) << j;
  }
  EXPECT_GT((exact - exact.transpose()).cwiseAbs().maxCoeff(), 0.1 * max_value);  // no potential
}

}  // namespace
}  // namespace overbend
