#include "model/vessel/fitted_circle.h"

#include <Eigen/Dense>
#include <cmath>

namespace overbend {
namespace {

constexpr double kStraight = 1e5;  // [m]: larger radii count as straight

/// Centre (x, z) and radius.
using Circle = Eigen::Vector3d;

/// Least squares of x^2 + z^2 = 2 a x + 2 b z + c, as a starting point.
Circle algebraic_circle(const std::vector<Eigen::Vector2d>& points) {
  Eigen::MatrixX3d lines(static_cast<Eigen::Index>(points.size()), 3);
  Eigen::VectorXd squares(lines.rows());
  for (Eigen::Index i = 0; i < lines.rows(); ++i) {
    const Eigen::Vector2d& p = points[static_cast<std::size_t>(i)];
    lines.row(i) << 2.0 * p.x(), 2.0 * p.y(), 1.0;
    squares[i] = p.squaredNorm();
  }
  const Eigen::Vector3d found = lines.colPivHouseholderQr().solve(squares);
  return {found.x(), found.y(), std::sqrt(found.z() + found.head<2>().squaredNorm())};
}

/// Performs a Gauss-Newton step on the distances from the circle.
Circle improved(const std::vector<Eigen::Vector2d>& points, const Circle& circle) {
  Eigen::MatrixX3d slopes(static_cast<Eigen::Index>(points.size()), 3);
  Eigen::VectorXd off(slopes.rows());
  for (Eigen::Index i = 0; i < slopes.rows(); ++i) {
    const Eigen::Vector2d from = points[static_cast<std::size_t>(i)] - circle.head<2>();
    const double distance = from.norm();
    slopes.row(i) << -from.x() / distance, -from.y() / distance, -1.0;
    off[i] = distance - circle.z();
  }
  return circle - Circle(slopes.colPivHouseholderQr().solve(off));
}

}  // namespace

std::optional<double> fitted_radius(const std::vector<Eigen::Vector2d>& points) {
  if (points.size() < 3) return std::nullopt;
  const double length = (points.back() - points.front()).norm();
  std::vector<Eigen::Vector2d> scaled;  // in units of a chord, relative to its middle
  for (const Eigen::Vector2d& p : points) scaled.emplace_back((p - 0.5 * (points.front() + points.back())) / length);
  Circle circle = algebraic_circle(scaled);
  for (int i = 0; i < 50 && circle.allFinite() && circle.z() * length < kStraight; ++i) {
    const Circle next = improved(scaled, circle);
    const bool found = (next - circle).norm() <= 1e-12 * next.norm();
    circle = next;
    if (found) break;
  }
  const bool bends_down = circle.allFinite() && circle.y() < 0.0 && circle.z() * length < kStraight;
  return bends_down ? std::optional(circle.z() * length) : std::nullopt;
}

std::optional<double> fitted_radius(const Supports& supports, Structure structure) {
  std::vector<Eigen::Vector2d> points;
  for (const SupportBox& box : supports.boxes) {
    if (box.structure == structure) points.emplace_back(box.curve_S.x(), box.curve_S.z());
  }
  return fitted_radius(points);
}

}  // namespace overbend
