#include "dynamics/integrator/dynamic_clock.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

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

TEST(clock, ends_with_the_first_row_at_or_after_the_duration) {
  EXPECT_DOUBLE_EQ(end_of_run(12.2, 0.5), 12.5);
  EXPECT_DOUBLE_EQ(end_of_run(12.0, 0.5), 12.0);
  EXPECT_DOUBLE_EQ(end_of_run(0.3, 0.1), 0.3);  // 0.3/0.1 is a little less than 3
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
  StepSizeController chooser;
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

/// The steps of a chooser that finds no error, after one of `first`.
std::vector<double> steps_without_error(double first, int count, double max_step) {
  StepSizeController chooser;
  std::vector<double> steps = {first};
  for (int i = 0; i < count; ++i) {
    chooser.took(steps.back());
    chooser.adapt(0.0, 1e-3, max_step);
    steps.push_back(chooser.wanted);
  }
  return steps;
}

TEST(step_chooser, makes_every_length_serve_twice_before_it_grows) {
  const std::vector<double> steps = steps_without_error(1e-3, 6, 1.0);
  for (std::size_t i = 0; i + 2 < steps.size(); i += 2) {
    EXPECT_EQ(steps[i + 1], steps[i]);
    EXPECT_NEAR(steps[i + 2] / steps[i + 1], 2.25, 1e-12);
  }
  EXPECT_EQ(steps_without_error(1e-3, 6, 2e-3).back(), 2e-3);
}

TEST(step_chooser, shrinks_at_once_where_the_error_is_too_large) {
  StepSizeController chooser;
  chooser.took(0.1);
  chooser.adapt(8e-3, 1e-3, 1.0);
  EXPECT_NEAR(chooser.wanted, 0.1 * 0.9 / 2.0, 1e-12);  // the error goes with the cube of the step
  chooser.took(0.1);
  chooser.adapt(1.0, 1e-6, 1.0);
  EXPECT_NEAR(chooser.wanted, 0.03, 1e-12);
}

/// Number of 20 steps of 1 ms with an error estimate, each as `error`.
int estimates(double error, double max_step) {
  StepSizeController chooser;
  int estimated = 0;
  for (int i = 0; i < 20; ++i) {
    chooser.took(1e-3);
    EXPECT_EQ(chooser.error(1e-3, max_step, [&] { return ++estimated, error; }), error);
  }
  return estimated;
}

TEST(step_chooser, estimates_one_error_in_five_where_they_are_next_to_nothing) {
  EXPECT_EQ(estimates(5e-6, 0.1), 4);
  EXPECT_EQ(estimates(5e-5, 0.1), 20);
}

TEST(step_chooser, leaves_no_error_unseen_for_longer_than_a_tenth_of_the_longest_step) {
  EXPECT_EQ(estimates(5e-6, 0.025), 7);  // two go unseen
  EXPECT_EQ(estimates(5e-6, 1e-3), 20);
}

TEST(step_chooser, estimates_the_error_of_a_step_that_its_length_makes_large) {
  StepSizeController chooser;
  int estimated = 0;
  for (const double h : {1e-3, 2e-3, 4e-3}) {  // by the cube: 1e-6, 8e-6, 64e-6, of which a hundredth of 1e-3 is 1e-5
    chooser.took(h);
    chooser.error(1e-3, 1.0, [&] { return ++estimated, 1e-6; });
  }
  EXPECT_EQ(estimated, 2);
}

TEST(step_chooser, begins_with_short_steps_where_a_line_parts) {
  StepSizeController chooser;
  chooser.wanted = 0.125;
  chooser.took(0.125);
  chooser.error(1e-3, 1.0, [] { return 1e-9; });  // of rest
  chooser.restart_with_step(1e-3);
  EXPECT_LE(chooser.choose(0.125, 1e300), 1e-3);
  chooser.took(1e-3);
  EXPECT_EQ(chooser.error(1e-3, 1.0, [] { return 5.0; }), 5.0);  // nothing that was estimated before serves
  chooser.restart_with_step(1e-3);
  chooser.wanted = 1e-4;
  chooser.restart_with_step(1e-3);
  EXPECT_EQ(chooser.wanted, 1e-4);
}

TEST(step_chooser, goes_on_from_what_it_saved) {
  StepSizeController chooser, second;
  chooser.wanted = 0.04;
  chooser.choose(0.1, 1e300);
  for (int i = 0; i < 2; ++i) chooser.took(chooser.last);
  chooser.error(1e-3, 1.0, [] { return 1e-6; });
  second.restore(chooser.save());
  EXPECT_EQ(second.choose(0.07, 1e300), chooser.choose(0.07, 1e300));
  for (StepSizeController* step_chooser : {&chooser, &second}) step_chooser->adapt(0.0, 1e-3, 1.0);
  EXPECT_EQ(second.wanted, chooser.wanted);
  EXPECT_EQ(second.error(1e-3, 1.0, [] { return 1.0; }), 1e-6);
}

TEST(tension_watch, follows_a_swing_by_about_sixty_steps_a_period) {
  constexpr double kPeriod = 8.0, kPi = 3.14159265358979323846;
  const auto tension = [](double t) { return 5e5 + 1e5 * std::sin(2.0 * kPi * t / kPeriod); };
  TensionMonitor watch;
  watch.start(tension(0.0));
  double t = 0.0, h = 0.05, min_step = 1e9;
  while (t < 3.0 * kPeriod) {
    t += h;
    const double next = std::min(watch.max_allowed_step(tension(t), h, {0.02, 0.001}), 1.0);
    watch.took(tension(t), h);
    h = next;
    if (t > kPeriod) min_step = std::min(min_step, h);
  }
  EXPECT_GT(min_step, kPeriod / 90.0);
  EXPECT_LT(min_step, kPeriod / 45.0);
}

TEST(tension_watch, asks_for_much_shorter_steps_where_a_line_snaps_and_not_where_it_trembles) {
  TensionMonitor watch;
  watch.start(0.0);
  watch.took(1e6, 1.0);
  watch.took(1e6, 1.0);
  watch.took(1e6, 1.0);  // a range of 1 MN, of which 5 kN may be bent in a step
  const MinSteps min_step{0.02, 0.001};
  EXPECT_EQ(watch.max_allowed_step(1.01e6, 0.02, min_step), 0.02);
  EXPECT_NEAR(watch.max_allowed_step(1.5e6, 0.02, min_step), 0.02 * std::sqrt(7.5 / 500.0), 1e-9);
  EXPECT_EQ(watch.max_allowed_step(1e9, 0.02, {0.02, 0.02}), 0.02);
}

}  // namespace
}  // namespace overbend
