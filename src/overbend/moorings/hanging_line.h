/// A line with weight that hangs between two places without touching the bed: elastic catenary, in the air and under
/// water (moorings/catenary.h).
#pragma once

#include "moorings/catenary.h"

namespace overbend {

/// What such a line pulls by.
struct HangingForces {
  bool found = false;            ///< Else no shape was found: it is far too short.
  Vec3 on_first = Vec3::Zero();  ///< On what holds its first end [N].
  Vec3 on_second = Vec3::Zero();
  Mat3 stiffness = Mat3::Zero();  ///< d on_first / d place of the second end [N/m].
};

/// `line` from its first end to its second, without clumps and buoys.
HangingForces hanging_forces(const CatenaryLine& line, const Vec3& first, const Vec3& second);

}  // namespace overbend
