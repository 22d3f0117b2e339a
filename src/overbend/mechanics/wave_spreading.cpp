#include "mechanics/wave_spreading.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace overbend {
namespace {

constexpr int kCells = 4096;

}  // namespace

std::vector<double> spread_directions(double s, int count, Random& random) {
  // sqrt(2/(s + 1)) is the circular standard deviation; nothing is left beyond twelve of it.
  const double widest = std::min(std::numbers::pi, 12.0 * std::sqrt(2.0 / (s + 1.0)));
  const double width = 2.0 * widest / kCells;
  std::vector<double> share(kCells + 1, 0.0);
  for (int i = 0; i < kCells; ++i) {
    const double angle = -widest + width * (i + 0.5);
    share[i + 1] = share[i] + std::pow(std::cos(0.5 * angle), 2.0 * s);
  }
  std::vector<double> angles;
  for (int i = 0; i < count; ++i) {
    const double wanted = (i + random.uniform()) / count * share.back();
    const auto above = std::upper_bound(share.begin() + 1, share.end() - 1, wanted);
    const auto cell = static_cast<std::size_t>(above - share.begin()) - 1;
    const double part = (wanted - share[cell]) / (share[cell + 1] - share[cell]);
    angles.push_back(-widest + width * (static_cast<double>(cell) + part));
  }
  for (std::size_t left = angles.size(); left > 1; --left) {
    std::swap(angles[left - 1], angles[random.below(left)]);
  }
  return angles;
}

}  // namespace overbend
