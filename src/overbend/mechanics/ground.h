/// Bed and route at a point of the line, plain scalar form; the kernel's is in mechanics/line_kernel_ground.h.
#pragma once

#include "base/vec.h"
#include "mechanics/line_kernel.h"

namespace overbend {

struct GroundPoint {
  double clearance = 0.0;             ///< Of the axis from the bed, along its normal [m].
  double off_route = 0.0;             ///< To port of the lay route [m].
  Vec3 normal = Vec3::UnitZ();        ///< Of the bed, W.
  Vec3 gradient = Vec3::UnitZ();      ///< Of `clearance`: the normal, but for the bed's curvature.
  Mat3 turn = Mat3::Zero();           ///< Derivative of the normal in the place [1/m].
  Vec3 across_route = Vec3::UnitY();  ///< Horizontal, to port, W.
  Vec3 along_route = Vec3::UnitX();   ///< On the bed, away from the barge, W.
};

GroundPoint ground_at(const LineEnvironment& env, const Vec3& r);

/// GroundPoint::clearance alone.
double bed_clearance(const LineEnvironment& env, const Vec3& r);

/// Derivative of `along_route` in the place, where the bed's normal turns; of a straight route [1/m].
Mat3 along_route_turn(const GroundPoint& at);

}  // namespace overbend
