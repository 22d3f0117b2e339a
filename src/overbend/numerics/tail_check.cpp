#include "numerics/tail_check.h"

#include <algorithm>
#include <cmath>

namespace overbend {

double upper_tail_distance(std::span<const double> shares) {
  constexpr double kMinTail = 1e-12;  // beyond a distribution's end the distance is large, not infinite
  const double n = static_cast<double>(shares.size());
  double sum = 0.5 * n;
  for (std::size_t i = 0; i < shares.size(); ++i) {
    const double share = std::clamp(shares[i], 0.0, 1.0 - kMinTail);
    sum -= 2.0 * share + (2.0 - (2.0 * static_cast<double>(i) + 1.0) / n) * std::log1p(-share);
  }
  return sum;
}

double min_probability(std::span<const double> expected) {
  double min_ratio = 1.0;
  for (std::size_t count = 1; count <= expected.size(); ++count) {
    const double mean = expected[count - 1];
    double term = std::exp(-mean), fewer = 0.0;  // Poisson
    for (std::size_t k = 0; k < count; ++k) {
      fewer += term;
      term *= mean / static_cast<double>(k + 1);
    }
    min_ratio = std::min(min_ratio, std::max(1.0 - fewer, 0.0));
  }
  return min_ratio;
}

}  // namespace overbend
