#include "mechanics/wave_spreading.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace overbend {
namespace {

constexpr int kCells = 4096;

}  // namespace

CosineSpreading::CosineSpreading(double s) {
  // sqrt(2/(s + 1)) is the circular standard deviation; nothing is left beyond twelve of it.
  widest_ = std::min(std::numbers::pi, 12.0 * std::sqrt(2.0 / (s + 1.0)));
  width_ = 2.0 * widest_ / kCells;
  share_.assign(kCells + 1, 0.0);
  for (int i = 0; i < kCells; ++i) {
    const double angle = -widest_ + width_ * (i + 0.5);
    share_[i + 1] = share_[i] + std::pow(std::cos(0.5 * angle), 2.0 * s);
  }
}

double CosineSpreading::quantile(double share) const {
  const double wanted = share * share_.back();
  const auto above = std::upper_bound(share_.begin() + 1, share_.end() - 1, wanted);
  const auto cell = static_cast<std::size_t>(above - share_.begin()) - 1;
  const double part = (wanted - share_[cell]) / (share_[cell + 1] - share_[cell]);
  return -widest_ + width_ * (static_cast<double>(cell) + part);
}

std::vector<double> shuffled_fractions(int count, Random& random) {
  std::vector<double> fractions;
  for (int i = 0; i < count; ++i) fractions.push_back((i + random.uniform()) / count);
  for (std::size_t left = fractions.size(); left > 1; --left) {
    std::swap(fractions[left - 1], fractions[random.below(left)]);
  }
  return fractions;
}

std::vector<double> spread_directions(double s, int count, Random& random) {
  const CosineSpreading spreading(s);
  std::vector<double> angles = shuffled_fractions(count, random);
  for (double& angle : angles) angle = spreading.quantile(angle);
  return angles;
}

}  // namespace overbend
