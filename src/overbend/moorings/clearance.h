/// Distances between lines and objects.
#pragma once

#include <vector>

#include "base/vec.h"

namespace overbend {

/// Minimum distance between two polylines of one or more points [m].
double polyline_distance(const std::vector<Vec3>& first, const std::vector<Vec3>& second);

/// Minimum distance between the segments a0-a1 and b0-b1 (Ericson, Real-Time Collision Detection, 2005, section 5.1.9)
/// [m].
double segment_distance(const Vec3& a0, const Vec3& a1, const Vec3& b0, const Vec3& b1);

}  // namespace overbend
