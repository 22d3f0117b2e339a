#include "model/site/scattered_depths.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <utility>

#include "base/dense_algebra.h"
#include "base/vec.h"

namespace overbend {
namespace {

constexpr std::size_t kNearest = 9;
constexpr double kMaxGridPoints = 1e6;
constexpr double kMaxCrossings = 4e6;
constexpr double kCoordinateTolerance = 1e-6;  ///< Coordinates closer than this are identical [m].
/// Ratio of crossings to depths up to which the depths are treated as survey lines.
constexpr double kMaxEmptyRatio = 4.0;
constexpr int kMaxRings = 24;  ///< Max. number of rings of cells searched.
constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

struct Extent {
  double low, high;
};

Extent extent(const std::vector<double>& v) {
  const auto [low, high] = std::minmax_element(v.begin(), v.end());
  return {*low, *high};
}

/// Points sorted into square cells, for fast search of the nearest.
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

  /// Returns the indices of the nearest points; fewer, or none, if they are far away.
  std::vector<std::size_t> nearest(double east, double north) const {
    const int c = column(east), r = row(north), widest = std::min(std::max(columns_, rows_), kMaxRings);
    std::vector<std::size_t> found;
    int ring = 0;
    for (int further = 0; ring <= widest && further < 2; ++ring) {
      add_ring(c, r, ring, found);
      further += found.size() >= kNearest ? 1 : 0;  // a point of the next ring may be nearer than a corner of this
    }
    std::vector<std::pair<double, std::size_t>> away;
    away.reserve(found.size());
    for (const std::size_t i : found) {
      const double x = points_->east[i] - east, y = points_->north[i] - north;
      away.emplace_back(x * x + y * y, i);
    }
    const std::size_t count = std::min(away.size(), kNearest);
    std::partial_sort(away.begin(), away.begin() + static_cast<std::ptrdiff_t>(count), away.end());
    found.clear();
    for (std::size_t k = 0; k < count; ++k) found.push_back(away[k].second);
    return found;
  }

 private:
  int column(double east) const { return std::clamp(static_cast<int>((east - east_) / size_), 0, columns_ - 1); }
  int row(double north) const { return std::clamp(static_cast<int>((north - north_) / size_), 0, rows_ - 1); }
  std::size_t cell(int column, int row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) + static_cast<std::size_t>(column);
  }
  /// Cells of one ring: its first and last row entirely, of the other rows both ends.
  void add_ring(int column, int row, int ring, std::vector<std::size_t>& found) const {
    for (int r = std::max(row - ring, 0); r <= std::min(row + ring, rows_ - 1); ++r) {
      const int step = ring == 0 || std::abs(r - row) == ring ? 1 : 2 * ring;
      for (int c = column - ring; c <= column + ring; c += step) {
        if (c < 0 || c >= columns_) continue;
        const std::vector<std::size_t>& cell_points = cells_[cell(c, r)];
        found.insert(found.end(), cell_points.begin(), cell_points.end());
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
  double min_depth = 1e300, max_depth = -1e300;
  for (const std::size_t i : nearest) {
    const Vec3 basis(1.0, (points.east[i] - east) / spacing, (points.north[i] - north) / spacing);
    const double weight = 1.0 / (basis.y() * basis.y() + basis.z() * basis.z() + 1e-12);
    sum += weight * basis * basis.transpose();
    right += weight * points.depth[i] * basis;
    min_depth = std::min(min_depth, points.depth[i]);
    max_depth = std::max(max_depth, points.depth[i]);
  }
  // Points on one line leave the slope across it undetermined: take the minimum-norm solution.
  const Vec3 plane = min_norm_solution(sum, right);
  return std::clamp(plane.x(), min_depth, max_depth);
}

/// Distinct coordinates.
std::vector<double> distinct_sorted(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  std::vector<double> once;
  for (const double value : values) {
    if (once.empty() || value > once.back() + kCoordinateTolerance) once.push_back(value);
  }
  return once;
}

std::size_t find_index(const std::vector<double>& once, double value) {
  return static_cast<std::size_t>(std::lower_bound(once.begin(), once.end(), value - kCoordinateTolerance) -
                                  once.begin());
}

/// Grid on these lines, without depths.
Bathymetry empty_grid(const std::vector<double>& east, const std::vector<double>& north) {
  Bathymetry grid;
  grid.columns = static_cast<int>(east.size());
  grid.rows = static_cast<int>(north.size());
  for (const double y : north) {
    for (const double x : east) {
      grid.east.push_back(x);
      grid.north.push_back(y);
    }
  }
  grid.depth.assign(grid.east.size(), kNone);
  return grid;
}

/// Keeps the lines of a survey in which some crossings have no depth or several: uses the mean at each crossing. Empty
/// if most crossings would have no depth.
std::optional<Bathymetry> grid_on_survey_lines(const Bathymetry& points) {
  const std::vector<double> east = distinct_sorted(points.east), north = distinct_sorted(points.north);
  const double crossings = static_cast<double>(east.size()) * static_cast<double>(north.size());
  const double max_crossings = std::min(kMaxCrossings, kMaxEmptyRatio * static_cast<double>(points.depth.size()));
  if (east.size() < 2 || north.size() < 2 || crossings > max_crossings) return std::nullopt;
  Bathymetry grid = empty_grid(east, north);
  std::vector<int> counts(grid.depth.size(), 0);
  for (std::size_t i = 0; i < points.depth.size(); ++i) {
    const std::size_t index = find_index(north, points.north[i]) * east.size() + find_index(east, points.east[i]);
    const double before = counts[index] > 0 ? grid.depth[index] : 0.0;
    ++counts[index];
    grid.depth[index] = before + (points.depth[i] - before) / counts[index];
  }
  return grid;
}

std::vector<double> even_lines(const Extent& extent, double spacing) {
  const int count = std::max(2, 1 + static_cast<int>(std::lround((extent.high - extent.low) / spacing)));
  std::vector<double> lines;
  for (int i = 0; i < count; ++i) lines.push_back(extent.low + (extent.high - extent.low) * i / (count - 1));
  return lines;
}

/// Median distance of a point from its nearest neighbour at another position, from a thousand points.
double median_neighbour_distance(const Bathymetry& points, const Cells& cells) {
  std::vector<double> distances;
  const std::size_t step = 1 + points.depth.size() / 1000;
  for (std::size_t i = 0; i < points.depth.size(); i += step) {
    for (const std::size_t j : cells.nearest(points.east[i], points.north[i])) {
      const double away = std::hypot(points.east[j] - points.east[i], points.north[j] - points.north[i]);
      if (away <= kCoordinateTolerance) continue;
      distances.push_back(away);
      break;
    }
  }
  if (distances.empty()) return 0.0;
  const auto middle = distances.begin() + static_cast<std::ptrdiff_t>(distances.size() / 2);
  std::nth_element(distances.begin(), middle, distances.end());
  return *middle;
}

/// Grid points without nearby depths get the mean of their neighbours, outwards from the depths.
void fill_gaps(Bathymetry& grid) {
  const auto columns = static_cast<std::size_t>(grid.columns), rows = static_cast<std::size_t>(grid.rows);
  const auto neighbours = [&](std::size_t index, auto&& visit) {
    const std::size_t column = index % columns, row = index / columns;
    if (column > 0) visit(index - 1);
    if (column + 1 < columns) visit(index + 1);
    if (row > 0) visit(index - columns);
    if (row + 1 < rows) visit(index + columns);
  };
  std::vector<std::size_t> front;
  std::vector<bool> waits(grid.depth.size(), false);
  const auto queue_empty_neighbours = [&](std::size_t index, std::vector<std::size_t>& list) {
    neighbours(index, [&](std::size_t next) {
      if (!std::isnan(grid.depth[next]) || waits[next]) return;
      waits[next] = true;
      list.push_back(next);
    });
  };
  for (std::size_t index = 0; index < grid.depth.size(); ++index) {
    if (!std::isnan(grid.depth[index])) queue_empty_neighbours(index, front);
  }
  while (!front.empty()) {
    std::vector<std::pair<std::size_t, double>> filled;
    for (const std::size_t index : front) {
      double sum = 0.0;
      int count = 0;
      neighbours(index, [&](std::size_t next) {
        if (std::isnan(grid.depth[next])) return;
        sum += grid.depth[next];
        ++count;
      });
      filled.emplace_back(index, sum / count);
    }
    for (const auto& [index, depth] : filled) grid.depth[index] = depth;
    front.clear();
    for (const auto& [index, depth] : filled) queue_empty_neighbours(index, front);
  }
}

}  // namespace

Bathymetry grid_scattered_depths(const Bathymetry& scattered) {
  const Extent east = extent(scattered.east), north = extent(scattered.north);
  const double width = east.high - east.low, height = north.high - north.low;
  const double count = std::min(static_cast<double>(scattered.depth.size()), kMaxGridPoints);
  const double max_extent = std::max(width, height);
  double spacing = std::max(std::sqrt(width * height / count), 1e-3 * max_extent);
  std::optional<Bathymetry> lines = grid_on_survey_lines(scattered);
  if (!lines) {
    // Based on the distance between points, not on the area of their extent, which is mostly empty for a diagonal
    // corridor.
    const double apart = median_neighbour_distance(scattered, Cells(scattered, 2.0 * spacing, east, north));
    const double finest = std::max(std::sqrt(width * height / kMaxGridPoints), 1e-3 * std::min(width, height));
    if (apart > 0.0) spacing = std::min(spacing, std::max(0.5 * apart, finest));
  }
  const bool kept = lines.has_value();
  Bathymetry grid = kept ? std::move(*lines) : empty_grid(even_lines(east, spacing), even_lines(north, spacing));
  const Cells cells(scattered, (kept ? 2.0 : 4.0) * spacing, east, north);
  for (std::size_t i = 0; i < grid.depth.size(); ++i) {
    if (!std::isnan(grid.depth[i])) continue;
    const std::vector<std::size_t> nearest = cells.nearest(grid.east[i], grid.north[i]);
    if (!nearest.empty()) grid.depth[i] = depth_at(scattered, nearest, grid.east[i], grid.north[i], spacing);
  }
  fill_gaps(grid);
  return grid;
}

}  // namespace overbend
