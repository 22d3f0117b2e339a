#include "statics/solver/support_outlier.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "base/shown_unit.h"

namespace overbend {
namespace {

using Point = Eigen::Vector2d;  ///< Astern and up, frame S.

/// Underside of the pipe at the tensioner and at the boxes.
std::vector<Point> support_points(const Model& model) {
  const TensionerDescription& tensioner = model.description.tensioner;
  std::vector<Point> points = {{tensioner.x, tensioner.z - 0.5 * model.pipe_section().outer_diameter}};
  for (const SupportBox& box : model.supports.boxes) points.emplace_back(box.point_S.x(), box.point_S.z());
  return points;
}

/// Twice the area of a triangle, positive if b is above the line from a to c.
double twice_area(const Point& a, const Point& b, const Point& c) {
  return (c - a).x() * (b - a).y() - (c - a).y() * (b - a).x();
}

/// Curvature of the circle through three points; 0 if two coincide.
double curvature(const Point& a, const Point& b, const Point& c) {
  const double product = (b - a).norm() * (c - b).norm() * (c - a).norm();
  return product > 0.0 ? 2.0 * twice_area(a, b, c) / product : 0.0;
}

double sharpest(const std::vector<Point>& points) {
  double max_curvature = 0.0;
  for (std::size_t i = 1; i + 1 < points.size(); ++i) {
    max_curvature = std::max(max_curvature, std::abs(curvature(points[i - 1], points[i], points[i + 1])));
  }
  return max_curvature;
}

double sharpest_without(std::vector<Point> points, std::size_t i) {
  points.erase(points.begin() + static_cast<std::ptrdiff_t>(i));
  return sharpest(points);
}

/// Index of the point without which the line is smoothest.
std::size_t find_outlier(const std::vector<Point>& points) {
  std::size_t found = 0;
  for (std::size_t i = 1; i < points.size(); ++i) {
    if (sharpest_without(points, i) < sharpest_without(points, found)) found = i;
  }
  return found;
}

/// Distance of a point above the line through two others.
double height_above(const Point& p, const Point& from, const Point& to) {
  const Point along = (to - from).normalized();
  return along.x() * (p - from).y() - along.y() * (p - from).x();
}

double curvature_at_yield(const Model& model) {
  const SteelDescription& steel = model.find_section_description(static_cast<std::size_t>(model.section_at(0.0))).steel;
  return 2.0 * steel.yield_stress / (steel.youngs_modulus * steel.outside_diameter);
}

}  // namespace

std::optional<SupportOutlier> support_outlier(const Model& model) {
  const std::vector<Point> points = support_points(model);
  const double yields_at = curvature_at_yield(model);
  if (points.size() < 4 || yields_at <= 0.0) return std::nullopt;
  const std::size_t i = find_outlier(points), last = points.size() - 1;
  const std::size_t a = i == 0 ? 1 : i == last ? last - 2 : i - 1, b = i == 0 ? 2 : i == last ? last - 1 : i + 1;
  const std::size_t first = std::min(i, a), third = std::max(i, b), second = i + a + b - first - third;
  SupportOutlier outlier{i == 0 ? "the tensioner" : "the box '" + model.supports.boxes[i - 1].name + "'",
                         height_above(points[i], points[a], points[b]),
                         std::abs(curvature(points[first], points[second], points[third])), 0.0};
  outlier.yield_ratio = outlier.curvature / yields_at;
  // A bend that yields the pipe over a height beyond alignment tolerances, one of many times that, or one far sharper
  // than all others.
  const double height = std::abs(outlier.height);
  const double beyond_others = outlier.yield_ratio - sharpest_without(points, i) / yields_at;
  const bool stands_out = (outlier.yield_ratio > 2.0 && height > 0.2) || (outlier.yield_ratio > 5.0 && height > 0.05) ||
                          (beyond_others > 1.0 && height > 1.0);
  return stands_out ? std::optional(outlier) : std::nullopt;
}

std::string outlier_message(const SupportOutlier& outlier) {
  return fmt::format(
      "{} is {} {} the line through its neighbours: a curvature of {}, {:.1f} times that at which the pipe yields; "
      "check its z and the sign of its offset",
      outlier.name, shown(std::abs(outlier.height), "m", 2), outlier.height > 0.0 ? "above" : "below",
      shown(outlier.curvature, "1/m", 4), outlier.yield_ratio);
}

}  // namespace overbend
