// The hull alone in calm water: released from an offset, on the springs of its moorings; and its energy.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "base/constants.h"
#include "support/hull_case.h"

namespace overbend {
namespace {

constexpr double kRadius = 0.8;  // spectral radius of the scheme

struct Extremum {
  double t, value;
};

/// Turning points of a freedom after a release, by parabolas.
std::vector<Extremum> decay(Vec6 offset, int mode, double step, double end, std::vector<Extremum>* values = nullptr) {
  const Hull& hull = testing::made_bgl1_hull().hull;
  HullState state = make_static_hull(hull, hull.drawn + offset);
  find_hull_acceleration(hull, {}, 0.0, state);
  std::vector<Extremum> found;
  Extremum last[2] = {{0.0, offset(mode)}, {0.0, offset(mode)}};
  EXPECT_TRUE(
      run_hull(hull, {}, kRadius, 0.0, step, static_cast<int>(end / step), state, [&](double t, const HullState& s) {
        const double x = s.h(mode) - hull.drawn(mode), b = last[1].value, a = last[0].value;
        if (values) values->push_back({t, x});
        if (last[0].t > 0.0 && (b - a) * (x - b) < 0.0) {
          const double slope = 0.5 * (x - a), curve = x - 2.0 * b + a;
          found.push_back({t - step - step * slope / curve, b - 0.5 * slope * slope / curve});
        }
        last[0] = last[1];
        last[1] = {t, x};
      }));
  return found;
}

TEST(hull_release, heave_decays_as_by_direct_convolution) {
  // An independent program's convolution of the same file, with the added mass that belongs to its kernel.
  std::vector<Extremum> z;
  const std::vector<Extremum> found = decay(Vec6::Unit(2), 2, 0.02, 13.0, &z);
  const std::pair<int, double> expected[] = {{1, 0.7484},  {2, 0.1523},  {3, -0.4299}, {4, -0.6894},
                                             {5, -0.5528}, {6, -0.1842}, {8, 0.3012},  {10, 0.0346}};
  for (const auto& [t, value] : expected) {
    EXPECT_NEAR(z[static_cast<std::size_t>(50 * t - 1)].value, value, 0.002) << t;
  }
  const Extremum extrema[] = {{4.12, -0.6925}, {8.08, 0.3021}, {11.76, -0.1537}};
  ASSERT_GE(found.size(), 3U);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_NEAR(found[i].value, extrema[i].value, 0.002);
    EXPECT_NEAR(found[i].t, extrema[i].t, 0.03);
  }
}

TEST(hull_release, roll_decays_as_by_direct_convolution_with_sway_and_yaw_free) {
  const std::vector<Extremum> found = decay(5.0 * kDegree * Vec6::Unit(3), 3, 0.02, 17.5);
  const Extremum expected[] = {{4.08, -4.170}, {8.18, 3.350}, {12.30, -2.649}, {16.40, 2.087}};
  ASSERT_GE(found.size(), 4U);
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_NEAR(found[i].value / kDegree, expected[i].value, 0.02);
    EXPECT_NEAR(found[i].t, expected[i].t, 0.02);
  }
}

TEST(hull_release, pitch_decays_as_by_direct_convolution_with_surge_free) {
  const std::vector<Extremum> found = decay(2.0 * kDegree * Vec6::Unit(4), 4, 0.02, 15.0);
  const Extremum expected[] = {{3.70, -1.6645}, {7.40, 1.0074}, {10.96, -0.5012}, {14.30, 0.2602}};
  ASSERT_GE(found.size(), 4U);
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_NEAR(found[i].value / kDegree, expected[i].value, 0.01);
    EXPECT_NEAR(found[i].t, expected[i].t, 0.03);
  }
}

TEST(hull_release, moored_hull_swings_with_its_natural_periods) {
  // Eigenvalues of hull, fitted memory and stiffness by an independent program: 66.96, 77.15, 44.64 s.
  const Hull& hull = testing::made_bgl1_hull().hull;
  const HullSprings springs = testing::on_eight_lines(hull.drawn);
  const std::pair<int, double> expected[] = {{0, 66.96}, {1, 77.15}, {5, 44.64}};
  for (const auto& [mode, period] : expected) {
    const double kick = mode == 5 ? 1.0 * kDegree : 1.0;
    HullState state = make_static_hull(hull, hull.drawn + kick * Vec6::Unit(mode));
    find_hull_acceleration(hull, springs, 0.0, state);
    std::vector<double> crossings;
    double before = kick, peak = 0.0;
    ASSERT_TRUE(run_hull(hull, springs, kRadius, 0.0, 0.25, 1600, state, [&](double t, const HullState& s) {
      const double x = s.h(mode) - hull.drawn(mode);
      if (before > 0.0 && x <= 0.0) crossings.push_back(t - 0.25 * x / (x - before));
      before = x;
      if (t > 300.0) peak = std::max(peak, std::abs(x));
    }));
    const auto n = static_cast<double>(crossings.size() - 1);
    EXPECT_NEAR((crossings.back() - crossings.front()) / n, period, 0.005 * period) << mode;
    EXPECT_LT(peak, kick) << mode;
    EXPECT_GT(peak, 0.9 * kick) << mode;  // radiation alone damps by 0.02 % of critical
  }
}

TEST(hull_release, energy_of_the_moored_hull_in_calm_water_never_grows) {
  const Hull& hull = testing::made_bgl1_hull().hull;
  const HullSprings springs = testing::on_eight_lines(hull.drawn);
  HullState state =
      make_static_hull(hull, hull.drawn + Vec6((Vec6() << 1, 1, 1, kDegree, kDegree, kDegree).finished()));
  find_hull_acceleration(hull, springs, 0.0, state);
  const auto held = [&](const HullState& s) {
    const HullEnergy e = hull_energy(hull, s, 0.0);
    const Vec6 off = s.h - springs.rest;
    return e.kinetic + e.hydrostatic + 0.5 * off.dot(springs.stiffness * off);
  };
  // The energy of the water around the hull comes and goes, but never more than was put in; and the slow swings, after
  // heave, roll and pitch have died out, shrink from each 400 s to the next.
  const double max_value = held(state);
  std::vector<Vec6> max_magnitude;
  ASSERT_TRUE(run_hull(hull, springs, kRadius, 0.0, 0.5, 21600, state, [&](double t, const HullState& s) {
    EXPECT_LE(held(s), max_value) << t;
    if (t > 400.0 * static_cast<double>(max_magnitude.size())) max_magnitude.push_back(Vec6::Zero());
    max_magnitude.back() = max_magnitude.back().cwiseMax((s.h - springs.rest).cwiseAbs());
  }));
  ASSERT_EQ(max_magnitude.size(), 27U);
  for (std::size_t i = 2; i < max_magnitude.size(); ++i) {
    // The largest of ten swings or so, seen every half second.
    for (const int k : {0, 1, 5}) EXPECT_LT(max_magnitude[i](k), max_magnitude[i - 1](k) * 1.0005) << i << ' ' << k;
  }
  for (const int k : {0, 1, 5}) EXPECT_LT(max_magnitude.back()(k), 0.97 * max_magnitude[1](k));
}

TEST(hull_release, energy_balance_closes_with_the_square_of_the_step) {
  Hull hull = testing::bgl1_in(testing::long_crested(2.5, 9.0, 1.2, 3, 60), WaveDrift::newman);
  hull.damping.quadratic(3) = 1e9;
  const HullSprings springs = testing::on_eight_lines(hull.drawn);
  const auto drift = [&](double step) {
    HullState state = make_static_hull(hull, hull.drawn);
    find_hull_acceleration(hull, springs, 0.0, state);
    double work = 0.0, last = hull_energy(hull, state, 0.0).power(), size = 0.0, error = 0.0;
    EXPECT_TRUE(run_hull(hull, springs, 1.0, 0.0, step, static_cast<int>(100.0 / step), state,
                         [&](double t, const HullState& s) {
                           const HullEnergy e = hull_energy(hull, s, t);
                           work += 0.5 * step * (last + e.power());
                           last = e.power();
                           const Vec6 off = s.h - springs.rest;
                           const double held = e.kinetic + e.hydrostatic + 0.5 * off.dot(springs.stiffness * off);
                           size = std::max(size, held);
                           error = std::max(error, std::abs(held - work));
                         }));
    return error / size;
  };
  const double coarse = drift(0.2), fine = drift(0.1);
  EXPECT_LT(fine, 3e-3);
  EXPECT_GT(coarse / fine, 3.0);
}

}  // namespace
}  // namespace overbend
