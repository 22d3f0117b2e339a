#include "model/site/seabed_shape.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "base/require.h"
#include "model/site/monotone_cubic.h"
#include "model/site/scattered_depths.h"

namespace overbend {
namespace {

/// Position of a coordinate between knots; beyond the ends clamped to them, with zero derivatives.
struct Interval {
  std::size_t from = 0;
  double length = 1.0, xi = 0.0;
  double inside = 1.0;  ///< 0 beyond the ends, else 1.
};

Interval interval(const std::vector<double>& knots, double x) {
  const auto after = std::upper_bound(knots.begin() + 1, knots.end() - 1, x);
  Interval span;
  span.from = static_cast<std::size_t>(after - knots.begin()) - 1;
  span.length = knots[span.from + 1] - knots[span.from];
  span.xi = std::clamp((x - knots[span.from]) / span.length, 0.0, 1.0);
  span.inside = x < knots.front() || x > knots.back() ? 0.0 : 1.0;
  return span;
}

/// Hermite weights of value and slope at both knots: the function and its derivatives.
struct Weights {
  double value[4], first[4], second[4];
};

Weights weights(const Interval& span) {
  const double x = span.xi, h = span.length, i = span.inside;
  return {
      {1 - 3 * x * x + 2 * x * x * x, h * (x - 2 * x * x + x * x * x), 3 * x * x - 2 * x * x * x,
       h * (x * x * x - x * x)},
      {i * (6 * x * x - 6 * x) / h, i * (1 - 4 * x + 3 * x * x), i * (6 * x - 6 * x * x) / h, i * (3 * x * x - 2 * x)},
      {i * (12 * x - 6) / (h * h), i * (6 * x - 4) / h, i * (6 - 12 * x) / (h * h), i * (6 * x - 2) / h}};
}

double sum(const double (&w)[4], const double (&v)[4]) {
  return w[0] * v[0] + w[1] * v[1] + w[2] * v[2] + w[3] * v[3];
}

SeabedPoint profile_point(const SeabedShape& shape, double x, double y) {
  const double* d = shape.along;
  const Interval span = interval(shape.x, (x - shape.origin[0]) * d[0] + (y - shape.origin[1]) * d[1]);
  const Weights w = weights(span);
  const double v[4] = {shape.z[span.from], shape.zx[span.from], shape.z[span.from + 1], shape.zx[span.from + 1]};
  const double slope = sum(w.first, v), bend = sum(w.second, v);
  return {sum(w.value, v), slope * d[0], slope * d[1], bend * d[0] * d[0], bend * d[0] * d[1], bend * d[1] * d[1]};
}

/// Values and cross slopes along one row of a grid, with their derivatives along the row.
struct RowPoint {
  double z, zx, zxx, zy, zxy, zxxy;
};

RowPoint row_point(const SeabedShape& shape, std::size_t row, const Interval& span, const Weights& w) {
  const std::size_t i = row * shape.x.size() + span.from, j = i + 1;
  const double v[4] = {shape.z[i], shape.zx[i], shape.z[j], shape.zx[j]};
  const double u[4] = {shape.zy[i], shape.zxy[i], shape.zy[j], shape.zxy[j]};
  return {sum(w.value, v), sum(w.first, v), sum(w.second, v), sum(w.value, u), sum(w.first, u), sum(w.second, u)};
}

SeabedPoint grid_point(const SeabedShape& shape, double x, double y) {
  const Interval in_x = interval(shape.x, x), in_y = interval(shape.y, y);
  const Weights wx = weights(in_x), wy = weights(in_y);
  const RowPoint a = row_point(shape, in_y.from, in_x, wx), b = row_point(shape, in_y.from + 1, in_x, wx);
  const double z[4] = {a.z, a.zy, b.z, b.zy}, zx[4] = {a.zx, a.zxy, b.zx, b.zxy},
               zxx[4] = {a.zxx, a.zxxy, b.zxx, b.zxxy};
  return {sum(wy.value, z),   sum(wy.value, zx), sum(wy.first, z),
          sum(wy.value, zxx), sum(wy.first, zx), sum(wy.second, z)};
}

/// Returns slopes along one direction of a grid: `count` lines of `values`, whose points have a stride of `step`.
std::vector<double> slopes_along(const std::vector<double>& knots, const std::vector<double>& values, std::size_t lines,
                                 std::size_t between_lines, std::size_t step) {
  std::vector<double> slopes(values.size()), line(knots.size());
  for (std::size_t l = 0; l < lines; ++l) {
    for (std::size_t i = 0; i < knots.size(); ++i) line[i] = values[l * between_lines + i * step];
    const std::vector<double> of_line = monotone_slopes(knots, line);
    for (std::size_t i = 0; i < knots.size(); ++i) slopes[l * between_lines + i * step] = of_line[i];
  }
  return slopes;
}

void set_slopes(SeabedShape& shape) {
  const std::size_t columns = shape.x.size(), rows = shape.y.size();
  shape.zx = slopes_along(shape.x, shape.z, rows, columns, 1);
  shape.zy = slopes_along(shape.y, shape.z, columns, 1, columns);
  // Twist in both orders of differentiation, which differ where slopes are limited.
  const std::vector<double> first = slopes_along(shape.x, shape.zy, rows, columns, 1);
  shape.zxy = slopes_along(shape.y, shape.zx, columns, 1, columns);
  for (std::size_t i = 0; i < first.size(); ++i) shape.zxy[i] = 0.5 * (shape.zxy[i] + first[i]);
}

/// Bound of a cubic by its Bezier points, from its values and slopes.
double compute_max_height(const SeabedShape& shape) {
  const auto widest = [](const std::vector<double>& knots) {
    double max_gap = 0.0;
    for (std::size_t i = 1; i < knots.size(); ++i) max_gap = std::max(max_gap, knots[i] - knots[i - 1]);
    return max_gap;
  };
  const double hx = widest(shape.x) / 3.0, hy = widest(shape.y) / 3.0;
  double highest = -1e30;
  for (std::size_t i = 0; i < shape.z.size(); ++i) {
    highest = std::max(highest, shape.z[i] + hx * std::abs(shape.zx[i]) + hy * std::abs(shape.zy[i]) +
                                    hx * hy * std::abs(shape.zxy[i]));
  }
  return highest;
}

}  // namespace

SeabedPoint bed_point(const SeabedShape& shape, double x, double y) {
  return shape.y.empty() ? profile_point(shape, x, y) : grid_point(shape, x, y);
}

void bed_values(const SeabedShape* shape, double x, double y, double* six) {
  const SeabedPoint point = bed_point(*shape, x, y);
  six[0] = point.z;
  six[1] = point.zx;
  six[2] = point.zy;
  six[3] = point.zxx;
  six[4] = point.zxy;
  six[5] = point.zyy;
}

std::shared_ptr<const SeabedShape> profile_shape(const std::vector<ProfilePoint>& points, const double* origin,
                                                 const double* along) {
  require(points.size() >= 2, "a profile has two points");
  auto shape = std::make_shared<SeabedShape>();
  for (int i = 0; i < 2; ++i) {
    shape->origin[i] = origin[i];
    shape->along[i] = along[i];
  }
  for (const ProfilePoint& point : points) {
    shape->x.push_back(point.x);
    shape->z.push_back(-point.depth);
  }
  shape->zx = monotone_slopes(shape->x, shape->z);
  shape->highest = *std::max_element(shape->z.begin(), shape->z.end());  // monotone in between
  return shape;
}

std::shared_ptr<const SeabedShape> grid_shape(const Bathymetry& depths) {
  const Bathymetry grid = depths.columns > 0 ? depths : grid_scattered_depths(depths);
  auto shape = std::make_shared<SeabedShape>();
  const auto columns = static_cast<std::size_t>(grid.columns), rows = static_cast<std::size_t>(grid.rows);
  require(columns >= 2 && rows >= 2 && grid.depth.size() == columns * rows, "a grid is two by two or more");
  shape->x.assign(grid.east.begin(), grid.east.begin() + grid.columns);
  for (std::size_t row = 0; row < rows; ++row) shape->y.push_back(grid.north[row * columns]);
  for (const double depth : grid.depth) shape->z.push_back(-depth);
  set_slopes(*shape);
  shape->highest = compute_max_height(*shape);
  return shape;
}

}  // namespace overbend
