/// Suspended line with weight between two points, without contact with the bed: elastic catenary in air and water
/// (moorings/catenary.h).
#pragma once

#include "moorings/catenary.h"

namespace overbend {

/// Forces of a suspended line on its ends.
struct SuspendedLineForces {
  bool found = false;            ///< If false, no shape was found: the line is far too short.
  Vec3 on_first = Vec3::Zero();  ///< Force on the attachment of its first end [N].
  Vec3 on_second = Vec3::Zero();
  Mat3 stiffness = Mat3::Zero();  ///< d on_first / d position of the second end [N/m].
};

/// Computes the forces of `line` from its first end to its second, without clump weights and buoys.
SuspendedLineForces suspended_line_forces(const CatenaryLine& line, const Vec3& first, const Vec3& second);

}  // namespace overbend
