#include "model/site/sea_statistics.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "base/constants.h"
#include "base/shown_unit.h"

namespace overbend {

SeaStatistics sea_statistics(const std::vector<SpectrumPoint>& points) {
  double m0 = 0.0, m2 = 0.0;
  for (std::size_t i = 1; i < points.size(); ++i) {
    const double a = points[i - 1].omega, b = points[i].omega, h = b - a;
    const double s = points[i - 1].density, e = points[i].density, middle = 0.5 * (s + e), w = 0.5 * (a + b);
    m0 += h * middle;
    m2 += h / 6.0 * (a * a * s + 4.0 * w * w * middle + b * b * e);  // Simpson's rule: a cubic, so exact
  }
  if (!(m0 > 0.0) || !(m2 > 0.0)) return {};
  const auto peak = std::max_element(points.begin(), points.end(), [](const SpectrumPoint& p, const SpectrumPoint& q) {
    return p.density < q.density;
  });
  return {4.0 * std::sqrt(m0), kTurn / peak->omega, kTurn * std::sqrt(m0 / m2)};
}

SeaStatistics record_statistics(const ElevationRecord& record) {
  const std::vector<double>& y = record.elevation;
  double squares = 0.0;
  int crossings = 0;
  for (std::size_t i = 0; i < y.size(); ++i) {
    squares += y[i] * y[i];
    if (i > 0 && y[i - 1] < 0.0 && y[i] >= 0.0) ++crossings;
  }
  SeaStatistics sea;
  if (!y.empty()) sea.hs = 4.0 * std::sqrt(squares / static_cast<double>(y.size()));
  if (crossings > 0) sea.tz = record.duration() / crossings;
  return sea;
}

std::string sea_statistics_label(const std::vector<SpectrumPoint>& points) {
  const SeaStatistics sea = sea_statistics(points);
  return fmt::format("Hs {}, Tp {:.3g} s, Tz {:.3g} s", shown_digits(sea.hs, "m", 3), sea.tp, sea.tz);
}

}  // namespace overbend
