#include "statics/solver/support_line.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "base/constants.h"
#include "base/shown_unit.h"

namespace overbend {
namespace {

constexpr double kFarthestBox = 1000.0;              ///< Twice the length of the longest pipelay vessels [m].
constexpr double kMaxTurn = 0.5 * std::numbers::pi;  ///< Maximum turn of the support line at one box [rad].
constexpr double kMinOffset = 15.0;                  ///< A wrong sign on an ordinary stinger is not reported here
                                                     ///< [m].

/// Angle by which the line a, b, c turns at b [rad].
double turn(const Vec3& a, const Vec3& b, const Vec3& c) {
  const Vec3 before = b - a, after = c - b;
  return std::atan2(before.cross(after).norm(), before.dot(after));
}

/// Maximum turn along the points without the one at `left_out` [rad].
double max_turn_without(const std::vector<Vec3>& points, std::size_t left_out) {
  std::vector<Vec3> rest = points;
  if (left_out < rest.size()) {
    rest.erase(rest.begin() + static_cast<std::ptrdiff_t>(left_out));
  }
  double max_turn = 0.0;
  for (std::size_t i = 1; i + 1 < rest.size(); ++i) {
    max_turn = std::max(max_turn, turn(rest[i - 1], rest[i], rest[i + 1]));
  }
  return max_turn;
}

/// Distance of a point from the line through its neighbours; at the end from the line through the two points before it
/// [m].
double off_neighbours(const std::vector<Vec3>& points, std::size_t i) {
  const bool last = i + 1 == points.size();
  const Vec3& from = points[last ? i - 2 : i - 1];
  const Vec3 along = (points[last ? i - 1 : i + 1] - from).normalized();
  const Vec3 off = points[i] - from;
  return (off - off.dot(along) * along).norm();
}

/// Index of the box without which the maximum turn is smallest; points begin with the tensioner.
std::size_t find_outlier(const std::vector<Vec3>& points) {
  std::size_t found = 1;
  for (std::size_t i = 2; i < points.size(); ++i) {
    found = max_turn_without(points, i) < max_turn_without(points, found) ? i : found;
  }
  return found;
}

}  // namespace

std::optional<StaticFailure> misplaced_box(const Model& model, const LayPlane& plane) {
  std::vector<Vec3> points{plane.tensioner_W};
  for (const SupportBox& box : model.supports.boxes) {
    points.push_back(point_from_ramp(model, model.mean_pose, box.point_S));
    const double far = (points.back() - plane.tensioner_W).norm();
    if (far > kFarthestBox) {
      return StaticFailure{"a box is out of the pipe's reach", fmt::format("box '{}'", box.name),
                           fmt::format("it is {} from the tensioner; ramps and stingers extend no farther than {}: "
                                       "check its x and z, and their units",
                                       shown(far, "m", 0), shown(kFarthestBox, "m", 0))};
    }
  }
  const double sharpest = max_turn_without(points, points.size());
  if (sharpest <= kMaxTurn) {
    return std::nullopt;
  }
  const std::size_t worst = find_outlier(points);
  const double off = off_neighbours(points, worst);
  if (off < kMinOffset) {
    return std::nullopt;
  }
  const SupportBox& box = model.supports.boxes[worst - 1];
  return StaticFailure{"a box is far off the line of its neighbours", fmt::format("box '{}'", box.name),
                       fmt::format("at x = {}, z = {} it is {} off that line, which turns by {:.0f} degrees, too "
                                   "sharply for any pipe: check its x and z, and their units",
                                   shown(box.point_S.x(), "m", 3), shown(box.point_S.z(), "m", 3), shown(off, "m", 1),
                                   sharpest * kToDegrees)};
}

}  // namespace overbend
