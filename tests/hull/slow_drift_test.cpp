// Slow sway of the moored hull in a beam sea, by the slowly varying drift alone, against the formulas of a linear
// system.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "support/hull_case.h"

namespace overbend {
namespace {

constexpr double kStep = 0.5, kStart = 600.0, kHours = 3.0;
constexpr int kSeeds = 6;

/// The sea's mean and varying drift, without the first-order forces, which would hide the slow motion.
Hull driven_by_drift(std::uint64_t seed) {
  static const HydrodynamicData kDriftAlone = [] {
    HydrodynamicData data = testing::bgl1_hydrodynamics();
    for (auto& force : data.force) force.setZero();
    return data;
  }();
  Hull hull = testing::made_bgl1_hull().hull;
  const Sea sea = testing::long_crested(4.0, 12.9, 0.5 * std::numbers::pi, seed);
  hull.waves = make_hull_waves(kDriftAlone, sea, WaveDrift::newman, 5.182, hull.drawn(5));
  return hull;
}

struct Sway {
  double mean = 0.0, std = 0.0;  ///< [m]
};

Sway slow_sway(double damping) {
  double sum = 0.0, squares = 0.0;
  long count = 0;
  for (int seed = 1; seed <= kSeeds; ++seed) {
    const Hull hull = driven_by_drift(static_cast<std::uint64_t>(seed));
    HullSprings springs = testing::on_eight_lines(hull.drawn);
    springs.damping(1, 1) = damping;
    HullState state = make_static_hull(hull, hull.drawn);
    find_hull_acceleration(hull, springs, 0.0, state);
    const int steps = static_cast<int>((kStart + 3600.0 * kHours) / kStep);
    EXPECT_TRUE(run_hull(hull, springs, 0.8, 0.0, kStep, steps, state, [&](double t, const HullState& s) {
      if (t < kStart) return;
      const double sway = s.h(1) - hull.drawn(1);
      sum += sway;
      squares += sway * sway;
      ++count;
    }));
  }
  const double mean = sum / static_cast<double>(count);
  return {mean, std::sqrt(squares / static_cast<double>(count) - mean * mean)};
}

TEST(slow_drift, of_the_moored_hull_has_the_mean_and_the_standard_deviation_of_the_spectrum) {
  // Mean drift 217.8 kN on 184.79 kN/m; pi S_F/(2 b k) with S_F = 146,995 kN2 s/rad at 77.1 s. Newman's
  // products of roots have a tenth less there than the coefficient at the mean frequency (1.32e11 N2 s of 1.47e11).
  constexpr double kCritical = 4.54e6;  // [N s/m]
  for (const auto& [ratio, expected] : {std::pair{0.2, 1.173}, {0.1, 1.660}}) {
    const Sway sway = slow_sway(ratio * kCritical);
    EXPECT_NEAR(sway.mean, 217.8 / 184.79, 0.02 * 217.8 / 184.79) << ratio;
    EXPECT_NEAR(sway.std, expected, 0.1 * expected) << ratio;
  }
}

}  // namespace
}  // namespace overbend
