#include "model/scattered_depths.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "base/dense_algebra.h"
#include "base/vec.h"

namespace overbend {
namespace {

constexpr std::size_t kNearest = 9;
constexpr double kMostPoints = 1e6;

struct Extent {
  double low, high;
};

Extent extent(const std::vector<double>& v) {
  const auto [low, high] = std::minmax_element(v.begin(), v.end());
  return {*low, *high};
}

/// Points sorted into square cells, so that the nearest are found without looking at all.
class Cells {
 public:
  Cells(const Bathymetry& points, double size, const Extent& east, const Extent& north)
      : points_(&points), size_(size), east_(east.low), north_(north.low) {
    columns_ = 1 + static_cast<int>((east.high - east.low) / size);
    rows_ = 1 + static_cast<int>((north.high - north.low) / size);
    cells_.resize(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_));
    for (std::size_t i = 0; i < points.depth.size(); ++i) {
      cells_[cell(column(points.east[i]), row(points.north[i]))].push_back(i);
    }
  }

  /// Indices of the nearest points, as many as are wanted and there.
  std::vector<std::size_t> nearest(double east, double north) const {
    const int c = column(east), r = row(north), widest = std::max(columns_, rows_);
    std::vector<std::size_t> found;
    int ring = 0;
    for (int further = 0; ring <= widest && further < 2; ++ring) {
      add_ring(c, r, ring, found);
      further += found.size() >= kNearest ? 1 : 0;  // a point of the next ring may be nearer than a corner of this
    }
    const auto away = [&](std::size_t i) { return std::hypot(points_->east[i] - east, points_->north[i] - north); };
    std::sort(found.begin(), found.end(), [&](std::size_t a, std::size_t b) { return away(a) < away(b); });
    found.resize(std::min(found.size(), kNearest));
    return found;
  }

 private:
  int column(double east) const { return std::clamp(static_cast<int>((east - east_) / size_), 0, columns_ - 1); }
  int row(double north) const { return std::clamp(static_cast<int>((north - north_) / size_), 0, rows_ - 1); }
  std::size_t cell(int column, int row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) + static_cast<std::size_t>(column);
  }
  void add_ring(int column, int row, int ring, std::vector<std::size_t>& found) const {
    for (int r = std::max(row - ring, 0); r <= std::min(row + ring, rows_ - 1); ++r) {
      for (int c = std::max(column - ring, 0); c <= std::min(column + ring, columns_ - 1); ++c) {
        if (std::max(std::abs(r - row), std::abs(c - column)) != ring) continue;
        const std::vector<std::size_t>& here = cells_[cell(c, r)];
        found.insert(found.end(), here.begin(), here.end());
      }
    }
  }

  const Bathymetry* points_;
  double size_, east_, north_;
  int columns_ = 1, rows_ = 1;
  std::vector<std::vector<std::size_t>> cells_;
};

double depth_at(const Bathymetry& points, const std::vector<std::size_t>& nearest, double east, double north,
                double spacing) {
  Mat3 sum = Mat3::Zero();
  Vec3 right = Vec3::Zero();
  double least = 1e300, most = -1e300;
  for (const std::size_t i : nearest) {
    const Vec3 at(1.0, (points.east[i] - east) / spacing, (points.north[i] - north) / spacing);
    const double weight = 1.0 / (at.y() * at.y() + at.z() * at.z() + 1e-12);
    sum += weight * at * at.transpose();
    right += weight * points.depth[i] * at;
    least = std::min(least, points.depth[i]);
    most = std::max(most, points.depth[i]);
  }
  // Points on one line leave the plane's fall across it open: the smallest that fits.
  const Vec3 plane = shortest_least_squares(sum, right);
  return std::clamp(plane.x(), least, most);
}

}  // namespace

Bathymetry gridded(const Bathymetry& scattered) {
  const Extent east = extent(scattered.east), north = extent(scattered.north);
  const double width = east.high - east.low, height = north.high - north.low;
  const double wanted = std::min(static_cast<double>(scattered.depth.size()), kMostPoints);
  const double spacing = std::max(std::sqrt(width * height / wanted), 1e-3 * std::max(width, height));
  Bathymetry grid;
  grid.columns = std::max(2, 1 + static_cast<int>(std::lround(width / spacing)));
  grid.rows = std::max(2, 1 + static_cast<int>(std::lround(height / spacing)));
  const Cells cells(scattered, 2.0 * spacing, east, north);
  for (int row = 0; row < grid.rows; ++row) {
    for (int column = 0; column < grid.columns; ++column) {
      const double x = east.low + width * column / (grid.columns - 1);
      const double y = north.low + height * row / (grid.rows - 1);
      grid.east.push_back(x);
      grid.north.push_back(y);
      grid.depth.push_back(depth_at(scattered, cells.nearest(x, y), x, y, spacing));
    }
  }
  return grid;
}

}  // namespace overbend
