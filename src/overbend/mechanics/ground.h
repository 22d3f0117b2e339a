/// Seabed and lay route at a point of the line, plain scalar form; the kernel's is in mechanics/line_kernel_ground.h.
#pragma once

#include "base/vec.h"
#include "mechanics/line_kernel.h"

namespace overbend {

struct GroundPoint {
  double clearance = 0.0;             ///< Distance of the axis from the seabed, along its normal [m].
  double off_route = 0.0;             ///< Distance from the lay route, positive to port [m].
  Vec3 normal = Vec3::UnitZ();        ///< Normal of the seabed, W.
  Vec3 gradient = Vec3::UnitZ();      ///< Gradient of `clearance`: the normal, up to the curvature of the seabed.
  Mat3 turn = Mat3::Zero();           ///< Derivative of the normal with position [1/m].
  Vec3 across_route = Vec3::UnitY();  ///< Horizontal, to port, W.
  Vec3 along_route = Vec3::UnitX();   ///< On the seabed, away from the vessel, W.
};

/// Returns the seabed and the nearest point of the route at position `r` in W [m].
GroundPoint ground_at(const LineEnvironment& env, const Vec3& r);

/// Returns GroundPoint::clearance at position `r` in W [m].
double bed_clearance(const LineEnvironment& env, const Vec3& r);

/// Returns the derivative of `along_route` with position, due to the turning seabed normal; for a straight route [1/m].
Mat3 along_route_turn(const GroundPoint& ground);

}  // namespace overbend
