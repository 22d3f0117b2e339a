/// Distance between lines and objects.
#pragma once

#include <vector>

#include "base/vec.h"

namespace overbend {

/// Least distance between two polylines of one point or more each [m].
double distance_between(const std::vector<Vec3>& one, const std::vector<Vec3>& other);

/// Least distance between the straight stretches a0 to a1 and b0 to b1 (Ericson, Real-Time Collision Detection, 2005,
/// section 5.1.9) [m].
double distance_of_stretches(const Vec3& a0, const Vec3& a1, const Vec3& b0, const Vec3& b1);

}  // namespace overbend
