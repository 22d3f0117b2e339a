#include "hull/slow_motion.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace overbend {
namespace {

Vec6 at(double x, double y, double psi) {
  return (Vec6() << x, y, 0.0, 0.0, 0.0, psi).finished();
}

TEST(slow_motion, steps_of_any_length_give_the_same_for_a_linear_path) {
  const Vec6 h0 = at(1.0, -2.0, 0.3), h1 = at(5.0, 3.0, 0.9);
  const SlowMotion start{Vec3(0.5, -1.0, 0.1), Vec3(0.02, 0.01, -0.003)};
  const SlowMotion once = slow_motion_after(start, h0, h1, 12.0, 40.0);
  SlowMotion often = start;
  const double ends[] = {0.0, 0.001, 0.4, 0.41, 3.0, 11.9, 12.0};
  for (int i = 0; i < 6; ++i) {
    const auto place = [&](double t) -> Vec6 { return h0 + (h1 - h0) * (t / 12.0); };
    often = slow_motion_after(often, place(ends[i]), place(ends[i + 1]), ends[i + 1] - ends[i], 40.0);
  }
  EXPECT_LT((once.value - often.value).norm(), 1e-13);
  EXPECT_LT((once.rate - often.rate).norm(), 1e-13);
}

TEST(slow_motion, of_a_step_is_the_critically_damped_answer) {
  // u = x (1 - (1 + w t) exp(-w t)) from rest.
  const SlowMotion start = slow_motion_at_rest(at(0.0, 0.0, 0.0));
  const SlowMotion after = slow_motion_after(start, at(1.0, 1.0, 1.0), at(1.0, 1.0, 1.0), 15.0, 40.0);
  const double wt = 2.0 * std::numbers::pi / 40.0 * 15.0;
  EXPECT_NEAR(after.value(0), 1.0 - (1.0 + wt) * std::exp(-wt), 1e-14);
  EXPECT_NEAR(after.rate(2), wt / 15.0 * wt * std::exp(-wt), 1e-14);
}

TEST(slow_motion, hardly_sees_what_is_added_to_the_way_of_one_step) {
  // The answer to x = d t / step is d (w step)^2 / 6 at its end, but for a share of w step / 2: 2 % at 0.25 s.
  const SlowMotion start{Vec3(0.5, -1.0, 0.1), Vec3(0.02, 0.01, -0.003)};
  for (const double step : {0.02, 0.05, 0.25}) {
    const SlowMotion without = slow_motion_after(start, at(1.0, -2.0, 0.3), at(1.1, -2.1, 0.31), step, 40.0);
    const SlowMotion with = slow_motion_after(start, at(1.0, -2.0, 0.3), at(1.3, -2.1, 0.31), step, 40.0);
    const double share = std::pow(2.0 * std::numbers::pi / 40.0 * step, 2) / 6.0;
    EXPECT_NEAR(with.value(0) - without.value(0), 0.2 * share, 0.2 * 0.03 * share) << step;
  }
}

TEST(slow_motion, a_tenth_is_left_of_a_wave_of_13_seconds) {
  const double w = 2.0 * std::numbers::pi / 13.0, h = 0.1;
  SlowMotion u = slow_motion_at_rest(at(0.0, 0.0, 0.0));
  double max_value = 0.0;
  for (int i = 0; i < 4000; ++i) {
    u = slow_motion_after(u, at(std::sin(w * h * i), 0.0, 0.0), at(std::sin(w * h * (i + 1)), 0.0, 0.0), h, 40.0);
    if (i > 3000) max_value = std::max(max_value, std::abs(u.value(0)));
  }
  const double ratio = 40.0 / 13.0;
  EXPECT_NEAR(max_value, 1.0 / (1.0 + ratio * ratio), 1e-3);
}

}  // namespace
}  // namespace overbend
