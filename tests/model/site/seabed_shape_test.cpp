#include "model/site/seabed_shape.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "model/site/scattered_depths.h"
#include "support/fixtures.h"

namespace overbend {
namespace {

using Height = std::function<double(double, double)>;

Bathymetry make_grid_from(int columns, int rows, double step, const Height& depth) {
  Bathymetry grid;
  grid.columns = columns;
  grid.rows = rows;
  for (int row = 0; row < rows; ++row) {
    for (int column = 0; column < columns; ++column) {
      grid.east.push_back(step * column);
      grid.north.push_back(step * row);
      grid.depth.push_back(depth(step * column, step * row));
    }
  }
  return grid;
}

std::shared_ptr<const SeabedShape> along_x(const std::vector<ProfilePoint>& points) {
  const double origin[2] = {0.0, 0.0}, along[2] = {1.0, 0.0};
  return profile_shape(points, origin, along);
}

/// Derivatives next to central differences.
void expect_derivatives(const SeabedShape& shape, double x, double y) {
  const double d = 1e-5;
  const SeabedPoint bed_at_point = bed_point(shape, x, y);
  const SeabedPoint e = bed_point(shape, x + d, y), w = bed_point(shape, x - d, y);
  const SeabedPoint n = bed_point(shape, x, y + d), s = bed_point(shape, x, y - d);
  EXPECT_NEAR(bed_at_point.zx, (e.z - w.z) / (2.0 * d), 1e-8);  // rounding of 100 m over the step
  EXPECT_NEAR(bed_at_point.zy, (n.z - s.z) / (2.0 * d), 1e-8);
  EXPECT_NEAR(bed_at_point.zxx, (e.zx - w.zx) / (2.0 * d), 1e-8);
  EXPECT_NEAR(bed_at_point.zxy, (e.zy - w.zy) / (2.0 * d), 1e-8);
  EXPECT_NEAR(bed_at_point.zxy, (n.zx - s.zx) / (2.0 * d), 1e-8);
  EXPECT_NEAR(bed_at_point.zyy, (n.zy - s.zy) / (2.0 * d), 1e-8);
}

TEST(bed_shape, profile_passes_through_its_points_and_is_level_beyond_and_across) {
  const auto shape = along_x({{0.0, 38.0}, {217.0, 38.0}, {232.0, 36.5}, {247.0, 38.0}, {600.0, 38.0}});
  EXPECT_EQ(bed_point(*shape, 232.0, 17.0).z, -36.5);
  EXPECT_EQ(bed_point(*shape, 232.0, -5.0).zx, 0.0);
  EXPECT_EQ(bed_point(*shape, 100.0, 0.0).z, -38.0);
  EXPECT_EQ(bed_point(*shape, -40.0, 0.0).z, -38.0);
  EXPECT_EQ(bed_point(*shape, 900.0, 0.0).z, -38.0);
  // Between two level knots the cubic is the smooth step: half way up half the height, slope 1.5 times the secant's.
  EXPECT_NEAR(bed_point(*shape, 224.5, 0.0).z, -37.25, 1e-12);
  EXPECT_NEAR(bed_point(*shape, 224.5, 0.0).zx, 0.15, 1e-12);
  EXPECT_EQ(shape->highest, -36.5);
}

TEST(bed_shape, profile_is_smooth_across_its_points_and_runs_along_its_direction) {
  const double origin[2] = {10.0, -20.0}, along[2] = {0.6, 0.8};
  const auto shape = profile_shape({{0.0, 20.0}, {10.0, 18.0}, {14.0, 17.0}, {30.0, 12.5}}, origin, along);
  for (const double x : {10.0, 14.0}) {
    const auto sample = [&](double t) { return bed_point(*shape, 10.0 + 0.6 * t, -20.0 + 0.8 * t); };
    EXPECT_NEAR(sample(x - 1e-9).z, sample(x + 1e-9).z, 1e-8);
    EXPECT_NEAR(sample(x - 1e-9).zx, sample(x + 1e-9).zx, 1e-8);
  }
  expect_derivatives(*shape, 10.0 + 0.6 * 12.0 + 3.0, -20.0 + 0.8 * 12.0);
  const SeabedPoint bed_at_first = bed_point(*shape, 15.0, -15.0),
                    bed_at_second = bed_point(*shape, 15.0 - 8.0, -15.0 + 6.0);
  EXPECT_NEAR(bed_at_first.z, bed_at_second.z, 1e-12);  // square to its direction nothing changes
}

TEST(bed_shape, grid_keeps_a_plane_exactly) {
  const auto shape =
      grid_shape(make_grid_from(5, 4, 20.0, [](double x, double y) { return 90.0 + 0.02 * x - 0.03 * y; }));
  const SeabedPoint bed_at_point = bed_point(*shape, 33.3, 41.7);
  EXPECT_NEAR(bed_at_point.z, -(90.0 + 0.02 * 33.3 - 0.03 * 41.7), 1e-12);
  EXPECT_NEAR(bed_at_point.zx, -0.02, 1e-13);
  EXPECT_NEAR(bed_at_point.zy, 0.03, 1e-13);
  EXPECT_NEAR(bed_at_point.zxx, 0.0, 1e-13);
  EXPECT_NEAR(bed_at_point.zxy, 0.0, 1e-13);
}

TEST(bed_shape, grid_is_smooth_across_its_lines_and_has_exact_derivatives) {
  const auto shape = grid_shape(testing::hummocks());
  expect_derivatives(*shape, 3.1, 0.6);
  expect_derivatives(*shape, -1.7, 2.2);
  for (const double d : {-1e-9, 1e-9}) {
    const SeabedPoint line = bed_point(*shape, 2.0, 0.6), bed_at_second = bed_point(*shape, 2.0 + d, 0.6);
    EXPECT_NEAR(line.z, bed_at_second.z, 1e-8);
    EXPECT_NEAR(line.zx, bed_at_second.zx, 1e-8);
    EXPECT_NEAR(line.zy, bed_at_second.zy, 1e-8);
  }
}

TEST(bed_shape, grid_makes_no_crest_between_level_depths) {
  const auto shape = grid_shape(make_grid_from(6, 6, 10.0, [](double x, double) { return x < 25.0 ? 50.0 : 40.0; }));
  for (double x = 0.0; x < 50.0; x += 0.7) {
    const double z = bed_point(*shape, x, 23.0).z;
    EXPECT_GE(z, -50.0 - 1e-12);
    EXPECT_LE(z, -40.0 + 1e-12);
  }
  EXPECT_EQ(bed_point(*shape, 500.0, 23.0).z, -40.0);  // level beyond the edge
  EXPECT_EQ(bed_point(*shape, 500.0, 23.0).zx, 0.0);
}

TEST(bed_shape, is_nowhere_above_its_highest) {
  const auto shape = grid_shape(testing::hummocks());
  for (double x = -3.0; x < 17.0; x += 0.31) {
    for (double y = -4.0; y < 4.7; y += 0.29) EXPECT_LE(bed_point(*shape, x, y).z, shape->highest);
  }
}

/// Points that fill an area of 300 m by 200 m evenly, without rows or columns.
Bathymetry scattered(int count, const Height& depth) {
  Bathymetry points;
  for (int i = 0; i < count; ++i) {
    points.east.push_back(300.0 * std::fmod(0.7548776662466927 * i, 1.0));
    points.north.push_back(200.0 * std::fmod(0.5698402909980532 * i, 1.0));
    points.depth.push_back(depth(points.east.back(), points.north.back()));
  }
  return points;
}

/// Largest difference of the gridded depths from what they were taken from, away from the edges.
double max_miss(const Bathymetry& grid, const Height& depth) {
  double miss = 0.0;
  for (std::size_t i = 0; i < grid.depth.size(); ++i) {
    const double x = grid.east[i], y = grid.north[i];
    if (x < 20.0 || x > 280.0 || y < 20.0 || y > 180.0) continue;
    miss = std::max(miss, std::abs(grid.depth[i] - depth(x, y)));
  }
  return miss;
}

TEST(scattered_depths, on_a_plane_are_gridded_to_that_plane) {
  const Height plane = [](double x, double y) { return 60.0 + 0.01 * x - 0.02 * y; };
  const Bathymetry grid = grid_scattered_depths(scattered(400, plane));
  EXPECT_LT(max_miss(grid, plane), 1e-9);
}

/// A sleeper across x on lines 3 m by 20 m.
Bathymetry lines_over_a_sleeper(const Height& bed) {
  Bathymetry points;
  for (int row = 0; row < 7; ++row) {
    for (int column = 0; column <= 100; ++column) {
      points.east.push_back(3.0 * column);
      points.north.push_back(20.0 * row);
      points.depth.push_back(bed(points.east.back(), points.north.back()));
    }
  }
  return points;
}

TEST(scattered_depths, of_a_grid_with_a_crossing_left_out_or_given_twice_stay_where_they_are) {
  const Height sleeper = [](double x, double) { return std::abs(x - 150.0) < 1.5 ? 39.2 : 40.0; };
  Bathymetry twice = lines_over_a_sleeper(sleeper), less = twice;
  twice.east.push_back(twice.east[5]);
  twice.north.push_back(twice.north[5]);
  twice.depth.push_back(twice.depth[5]);
  less.east.pop_back();
  less.north.pop_back();
  less.depth.pop_back();
  for (const Bathymetry& points : {twice, less}) {
    const Bathymetry grid = grid_scattered_depths(points);
    EXPECT_EQ(grid.columns, 101);
    EXPECT_EQ(grid.rows, 7);
    const auto shape = grid_shape(points);
    EXPECT_NEAR(bed_point(*shape, 150.0, 60.0).z, -39.2, 1e-12);
    EXPECT_NEAR(bed_point(*shape, 147.0, 60.0).z, -40.0, 1e-12);
  }
}

TEST(scattered_depths, of_a_corridor_are_the_same_bed_whichever_way_it_runs) {
  const double c = std::sqrt(0.5);
  Bathymetry turned;
  for (int i = -10; i <= 10; ++i) {
    for (int j = 0; j <= 200; ++j) {  // 3 m by 3 m, 60 m wide, 600 m long, to the north-east
      const double along = 3.0 * j, bed_at_second = 3.0 * i;
      turned.east.push_back(c * (along - bed_at_second));
      turned.north.push_back(c * (along + bed_at_second));
      turned.depth.push_back(std::abs(along - 300.0) < 4.0 ? 38.0 : 40.0);
    }
  }
  const auto shape = grid_shape(turned);
  EXPECT_NEAR(bed_point(*shape, c * 300.0, c * 300.0).z, -38.0, 0.1);
  EXPECT_NEAR(bed_point(*shape, c * 288.0, c * 288.0).z, -40.0, 0.1);
}

TEST(scattered_depths, come_closer_to_a_smooth_bed_the_more_there_are) {
  const Height swell = [](double x, double y) { return 60.0 + 2.0 * std::sin(x / 20.0) + std::cos(y / 15.0); };
  const double few = max_miss(grid_scattered_depths(scattered(400, swell)), swell);
  const double many = max_miss(grid_scattered_depths(scattered(3600, swell)), swell);
  EXPECT_LT(many, 0.25 * few);  // points three times as close: a ninth of the error of second order, where it is worst
  EXPECT_LT(many, 0.1);
}

}  // namespace
}  // namespace overbend
