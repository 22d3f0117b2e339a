/// Pull of a straight wire without weight.
#pragma once

#include "base/vec.h"
#include "system/system.h"

namespace overbend {

/// Of a wire between two places.
struct WirePull {
  double tension = 0.0;           ///< 0 while it is slack [N].
  double span = 0.0;              ///< Distance of its ends [m].
  Vec3 first = Vec3::Zero();      ///< Place of its first end, W [m].
  Vec3 second = Vec3::Zero();     ///< Of its second.
  Vec3 force = Vec3::Zero();      ///< On what holds its first end, W; the other end is pulled the opposite way [N].
  Mat3 stiffness = Mat3::Zero();  ///< d force / d place of the second end [N/m].
};

/// T = EA (span - length) / length where that is positive, or what its winch holds.
WirePull wire_pull(const Wire& wire, const Vec3& first, const Vec3& second);

}  // namespace overbend
