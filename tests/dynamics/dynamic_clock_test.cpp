#include "dynamics/dynamic_clock.h"

#include <gtest/gtest.h>

#include <cmath>

namespace overbend {
namespace {

TEST(clock, has_a_row_at_zero_and_at_the_end_whatever_the_build_up) {
  DynamicOptions options;
  options.build_up = 7.3;  // no multiple of the output step: begins earlier
  options.duration = 10.0;
  options.output_step = 0.5;
  Clock clock = make_clock(options, 0.25);
  EXPECT_DOUBLE_EQ(clock.time(), -7.5);
  int rows = 0;
  for (; clock.tick <= clock.last_tick; ++clock.tick) rows += clock.at_row() ? 1 : 0;
  EXPECT_EQ(rows, 15 + 1 + 20);
}

TEST(clock, names_the_row_after_any_tick) {
  Clock clock;
  clock.ticks_per_row = 4;
  for (const auto& [tick, next] : {std::pair{-9, -8}, {-8, -4}, {-1, 0}, {0, 4}, {3, 4}}) {
    clock.tick = tick;
    EXPECT_EQ(clock.next_row(), next) << tick;
  }
}

TEST(step_chooser, meets_the_tick_in_equal_steps_no_longer_than_wanted) {
  StepChooser chooser;
  chooser.wanted = 0.03;
  double remaining = 0.1;
  int steps = 0;
  while (remaining > 1e-12) {
    const double h = chooser.choose(remaining, 1e300);
    EXPECT_LE(h, 0.03 * (1.0 + 1e-9));
    EXPECT_NEAR(h, 0.025, 1e-12);
    remaining -= h;
    ++steps;
  }
  EXPECT_EQ(steps, 4);
}

TEST(tension_watch, follows_a_swing_by_about_sixty_steps_a_period) {
  constexpr double kPeriod = 8.0, kPi = 3.14159265358979323846;
  const auto tension = [](double t) { return 5e5 + 1e5 * std::sin(2.0 * kPi * t / kPeriod); };
  TensionWatch watch;
  watch.start(tension(0.0));
  double t = 0.0, h = 0.05, shortest = 1e9;
  while (t < 3.0 * kPeriod) {
    t += h;
    h = std::min(watch.longest_step(tension(t), h), 1.0);
    if (t > kPeriod) shortest = std::min(shortest, h);
  }
  EXPECT_GT(shortest, kPeriod / 90.0);
  EXPECT_LT(shortest, kPeriod / 45.0);
}

}  // namespace
}  // namespace overbend
