#include "model/vessel/fitted_circle.h"

#include <gtest/gtest.h>

#include <cmath>

namespace overbend {
namespace {

std::vector<Eigen::Vector2d> arc(double radius, double from, double to, int count) {
  std::vector<Eigen::Vector2d> points;
  for (int i = 0; i < count; ++i) {
    const double angle = from + (to - from) * i / (count - 1);
    points.emplace_back(40.0 + radius * std::sin(angle), -7.0 + radius * std::cos(angle));
  }
  return points;
}

TEST(fitted_circle, of_points_on_an_arc_is_the_arc) {
  for (const double radius : {12.0, 150.0, 2000.0}) {
    for (const double reach : {0.05, 0.3, 1.0}) {
      // places of 1e-15 relative, over an arc of 0.05 rad that is 3e-4 of the radius high
      EXPECT_NEAR(fitted_radius(arc(radius, 0.1, 0.1 + reach, 8)).value_or(0.0), radius, 1e-7 * radius);
    }
  }
  EXPECT_NEAR(fitted_radius(arc(90.0, 0.0, 0.4, 3)).value_or(0.0), 90.0, 1e-9);
}

/// Sum of squared distances from the best circle of a given radius whose centre is searched on a grid that shrinks.
double misfit(const std::vector<Eigen::Vector2d>& points, double radius) {
  Eigen::Vector2d centre(40.0, -7.0);
  double min_value = INFINITY;
  for (double step = 4.0; step > 1e-6; step *= 0.6) {
    const Eigen::Vector2d from = centre;
    for (int i = -3; i <= 3; ++i) {
      for (int j = -3; j <= 3; ++j) {
        const Eigen::Vector2d vector2d = from + step * Eigen::Vector2d(i, j);
        double sum = 0.0;
        for (const Eigen::Vector2d& p : points) sum += std::pow((p - vector2d).norm() - radius, 2);
        if (sum < min_value) {
          min_value = sum;
          centre = vector2d;
        }
      }
    }
  }
  return min_value;
}

TEST(fitted_circle, has_the_least_squared_distances_of_all) {
  std::vector<Eigen::Vector2d> points = arc(150.0, 0.05, 0.45, 7);
  for (std::size_t i = 0; i < points.size(); ++i) points[i].y() += (i % 2 == 0 ? 0.05 : -0.03);
  const double radius = fitted_radius(points).value_or(0.0), min_magnitude = misfit(points, radius);
  for (const double second : {0.98 * radius, 0.995 * radius, 1.005 * radius, 1.02 * radius}) {
    EXPECT_LT(min_magnitude, misfit(points, second)) << second / radius;
  }
}

TEST(fitted_circle, does_not_depend_on_where_the_frame_is) {
  const std::vector<Eigen::Vector2d> points = {{0, 0}, {10, -0.4}, {20, -1.4}, {30, -3.2}};
  std::vector<Eigen::Vector2d> moved;
  for (const Eigen::Vector2d& p : points) moved.push_back(p + Eigen::Vector2d(500.0, -80.0));
  EXPECT_NEAR(fitted_radius(points).value_or(0.0), fitted_radius(moved).value_or(1.0), 1e-6);
}

TEST(fitted_circle, there_is_none_of_two_points_a_line_or_a_hollow) {
  EXPECT_FALSE(fitted_radius({{0, 0}, {10, -1}}));
  EXPECT_FALSE(fitted_radius({{0, 0}, {10, -1}, {20, -2}, {30, -3}}));
  EXPECT_FALSE(fitted_radius({{0, 0}, {10, -5}, {20, 0}}));
}

}  // namespace
}  // namespace overbend
