#include "moorings/periods.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "base/dense_algebra.h"
#include "hull/damping_ratios.h"

namespace overbend {
namespace {

constexpr int kRounds = 20;  ///< Iterations of the added mass and its frequency; they converge in four.

Mat6 rigid_mass(const CoupledHullDescription& hull) {
  Vec6 diagonal;
  diagonal << Vec3::Constant(hull.mass), hull.mass * hull.gyration.cwiseAbs2();
  return diagonal.asDiagonal();
}

/// A mode of a pencil (stiffness, mass), scaled to unit kinetic energy.
struct Mode {
  double square = 0.0;  ///< omega^2 [1/s2].
  Vec6 shape = Vec6::Zero();
};

Mode make_mode(const SymmetricModes& modes, Eigen::Index i) {
  return {modes.values[i], modes.vectors.col(i)};
}

const char* dominant_motion_name(const Mode& mode, const Mat6& mass) {
  static constexpr std::array<const char*, 6> kModes = {"surge", "sway", "heave", "roll", "pitch", "yaw"};
  const Vec6 energy = mode.shape.cwiseProduct(mass * mode.shape);
  Eigen::Index max_index = 0;
  energy.maxCoeff(&max_index);
  return kModes[static_cast<std::size_t>(max_index)];
}

}  // namespace

std::vector<NaturalPeriod> natural_periods(const CoupledHullDescription& hull, const Mat6& stiffness) {
  const Mat6 even = 0.5 * (stiffness + stiffness.transpose());
  const auto mass_at = [&](double omega) -> Mat6 {
    if (!hull.data) return rigid_mass(hull);
    const Mat6 added = added_mass_at(*hull.data, omega);
    return rigid_mass(hull) + 0.5 * (added + added.transpose());
  };
  const double min_square = 1e-8 * even.diagonal().head<3>().cwiseAbs().maxCoeff() / std::max(hull.mass, 1.0);
  std::vector<NaturalPeriod> periods;
  const SymmetricModes first = symmetric_modes(even, mass_at(0.0));
  for (Eigen::Index i = 0; i < 6; ++i) {
    Mode mode = make_mode(first, i);
    Mat6 mass = mass_at(0.0);
    for (int round = 0; round < kRounds && mode.square > min_square; ++round) {
      mass = mass_at(std::sqrt(mode.square));
      mode = make_mode(symmetric_modes(even, mass), i);  // sorted by size, as each mode has its own frequency
    }
    if (mode.square > min_square) {
      periods.push_back({dominant_motion_name(mode, mass), 2.0 * std::numbers::pi / std::sqrt(mode.square)});
    }
  }
  std::stable_sort(periods.begin(), periods.end(), [](const auto& a, const auto& b) { return a.period > b.period; });
  return periods;
}

}  // namespace overbend
