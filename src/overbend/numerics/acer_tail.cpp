#include "numerics/acer_tail.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace overbend {
namespace {

constexpr double kMaxOffset = 3.0;  ///< Maximum distance of b below the lowest level, over the range of the levels.
constexpr double kMinPower = 0.5, kMaxPower = 5.0;
constexpr int kGrid = 8;  ///< Number of starting points in each direction.
constexpr double kFinest = 1e-3;
constexpr double kNear = 1.0 / 16.0;  ///< First step from an approximate tail.

/// Levels scaled to 0 to 1, logarithms of the rates and their weights.
struct Points {
  std::vector<double> x, y, w;
};

/// Best line for given b and c, with its residual.
struct Line {
  double log_q = 0.0, a = 0.0, rest = std::numeric_limits<double>::infinity();
};

Points make_points(std::span<const AcerLevel> levels) {
  Points points;
  const double from = levels.front().level, range = levels.back().level - from;
  double sum = 0.0;
  for (const AcerLevel& level : levels) {
    points.x.push_back((level.level - from) / range);
    points.y.push_back(std::log(level.rate));
    const double width = std::log(level.high / level.low);
    points.w.push_back(1.0 / (width * width));
    sum += points.w.back();
  }
  for (double& w : points.w) w /= sum;
  return points;
}

Line line_for(const Points& points, double b, double c) {
  double mean_z = 0.0, mean_y = 0.0, zz = 0.0, zy = 0.0, yy = 0.0;
  std::vector<double> z(points.x.size());
  for (std::size_t i = 0; i < z.size(); ++i) {
    z[i] = std::pow(points.x[i] - b, c);
    mean_z += points.w[i] * z[i];
    mean_y += points.w[i] * points.y[i];
  }
  for (std::size_t i = 0; i < z.size(); ++i) {
    const double dz = z[i] - mean_z, dy = points.y[i] - mean_y;
    zz += points.w[i] * dz * dz;
    zy += points.w[i] * dz * dy;
    yy += points.w[i] * dy * dy;
  }
  if (!(zz > 0.0) || !(zy < 0.0)) return {};
  return {mean_y - zy / zz * mean_z, -zy / zz, yy - zy * zy / zz};
}

/// b and the logarithm of c within their bounds.
struct Shape {
  double b = 0.0, log_c = 0.0;
};

Shape within(Shape shape) {
  return {std::clamp(shape.b, -kMaxOffset, 0.0), std::clamp(shape.log_c, std::log(kMinPower), std::log(kMaxPower))};
}

/// Compass search: the residual is smooth but has long flat valleys, along which b and c are nearly interchangeable.
Shape search_from(const Points& points, Shape start, double step) {
  constexpr double kSearchDirections[8][2] = {{1, 0}, {-1, 0}, {0, 1}, {0, -1}, {1, 1}, {-1, -1}, {1, -1}, {-1, 1}};
  Shape best = within(start);
  double rest = line_for(points, best.b, std::exp(best.log_c)).rest;
  while (step > kFinest) {
    bool better = false;
    for (const auto& direction : kSearchDirections) {
      const Shape trial = within({best.b + direction[0] * step * kMaxOffset, best.log_c + direction[1] * step});
      const double left = line_for(points, trial.b, std::exp(trial.log_c)).rest;
      if (left < rest) {
        rest = left;
        best = trial;
        better = true;
      }
    }
    if (!better) step *= 0.5;
  }
  return best;
}

Shape search(const Points& points) {
  const double low = std::log(kMinPower), high = std::log(kMaxPower);
  Shape best;
  double rest = std::numeric_limits<double>::infinity();
  for (int i = 0; i <= kGrid; ++i) {
    for (int j = 0; j <= kGrid; ++j) {
      const Shape trial{-kMaxOffset * i / kGrid, low + (high - low) * j / kGrid};
      const double left = line_for(points, trial.b, std::exp(trial.log_c)).rest;
      if (left < rest) {
        rest = left;
        best = trial;
      }
    }
  }
  return search_from(points, best, 1.0 / kGrid);
}

}  // namespace

double AcerTail::rate(double level) const {
  return q * std::exp(-a * std::pow(std::max(level - b, 0.0), c));
}

double AcerTail::level(double rate) const {
  return b + std::pow(std::log(q / rate) / a, 1.0 / c);
}

std::optional<AcerTail> fit_acer_tail(std::span<const AcerLevel> levels, const AcerTail* near) {
  if (levels.size() < 2 || !(levels.back().level > levels.front().level)) return std::nullopt;
  const Points points = make_points(levels);
  const double from = levels.front().level, range = levels.back().level - from;
  const Shape best =
      near == nullptr ? search(points) : search_from(points, {(near->b - from) / range, std::log(near->c)}, kNear);
  const double c = std::exp(best.log_c);
  const Line line = line_for(points, best.b, c);
  if (!std::isfinite(line.rest)) return std::nullopt;
  return AcerTail{std::exp(line.log_q), line.a / std::pow(range, c), from + range * best.b, c};
}

}  // namespace overbend
