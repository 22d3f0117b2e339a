#include "dynamics/integrator/impact_tracker.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace overbend {
namespace {

constexpr double kStiffness = 4e6, kMass = 100.0;

std::vector<BodyRoller> one_roller() {
  BodyRoller roller;
  roller.mass = kMass;
  roller.law.stiffness = kStiffness;
  return {roller};
}

/// A mass that meets an undamped spring at t = 0 with `speed`: half a sine, then it flies on.
RollerContact struck(double speed, double t) {
  const double w = std::sqrt(kStiffness / kMass);
  RollerContact contact;
  contact.closest.found = true;
  const bool touching = t > 0.0 && t < std::numbers::pi / w;
  contact.penetration = touching   ? speed / w * std::sin(w * t)
                        : t <= 0.0 ? speed * t
                                   : -speed * (t - std::numbers::pi / w);
  contact.rate = touching ? speed * std::cos(w * t) : t <= 0.0 ? speed : -speed;
  contact.normal = touching ? kStiffness * contact.penetration : 0.0;
  return contact;
}

std::vector<Impact> followed(double speed, double h, const ImpactSettings& settings = {}) {
  const std::vector<BodyRoller> rollers = one_roller();
  ImpactTracker tracker(rollers, settings);
  std::vector<EndedImpact> ended;
  for (double t = -20.3 * h; t < 0.1; t += h) tracker.accept({struck(speed, t)}, t, h, ended);
  std::vector<Impact> impacts;
  for (const EndedImpact& ended_impact : ended) impacts.push_back(ended_impact.impact);
  return impacts;
}

TEST(impact_tracker, records_force_impulse_and_duration_of_a_half_sine) {
  const double speed = 0.5, w = std::sqrt(kStiffness / kMass);
  const std::vector<Impact> impacts = followed(speed, 1e-5);
  ASSERT_EQ(impacts.size(), 1U);
  EXPECT_NEAR(impacts[0].time, 0.0, 1e-5);
  EXPECT_NEAR(impacts[0].approach_velocity, speed, 1e-3 * speed);
  EXPECT_NEAR(impacts[0].peak_force, speed * std::sqrt(kStiffness * kMass),
              1e-3 * speed * std::sqrt(kStiffness * kMass));
  EXPECT_NEAR(impacts[0].impulse, 2.0 * kMass * speed, 1e-3 * 2.0 * kMass * speed);  // the momentum turned round
  EXPECT_NEAR(impacts[0].duration, std::numbers::pi / w, 3e-5);
}

TEST(impact_tracker, passes_over_touches_too_soft_to_matter) {
  const double min_value = ImpactSettings{}.min_force / std::sqrt(kStiffness * kMass);
  EXPECT_TRUE(followed(0.9 * min_value, 1e-5).empty());
  EXPECT_EQ(followed(1.1 * min_value, 1e-5).size(), 1U);
}

TEST(impact_tracker, rejects_a_step_too_long_for_the_impact_it_runs_into) {
  const std::vector<BodyRoller> rollers = one_roller();
  ImpactTracker tracker(rollers, {});
  std::vector<EndedImpact> ended;
  const double h = 0.012, gap = 0.005, speed = 0.5;
  tracker.accept({struck(speed, -gap / speed)}, 0.0, h, ended);
  const ImpactLimit limit = tracker.check({struck(speed, h - gap / speed)}, h);
  EXPECT_TRUE(limit.reject);
  EXPECT_NEAR(limit.step, gap / speed, 0.1 * gap / speed);  // to the first touch
  EXPECT_FALSE(tracker.check({struck(speed, -0.5 * gap / speed)}, h).reject);
}

/// Apart from the roller, the gap `gap` closing at `rate`.
RollerContact apart(double gap, double rate) {
  RollerContact contact;
  contact.closest.found = true;
  contact.penetration = -gap;
  contact.rate = rate;
  return contact;
}

/// The longest step after one in which the pipe came nearer at a speed that fell evenly from 0.5 m/s to 0.4 m/s.
double extrapolated(double gap, const ImpactSettings& settings = {}) {
  const std::vector<BodyRoller> rollers = one_roller();
  ImpactTracker tracker(rollers, settings);
  std::vector<EndedImpact> ended;
  constexpr double kStep = 0.05;
  for (int i = 0; i < 2; ++i) tracker.accept({apart(gap + 0.45 * kStep, 0.5)}, 0.0, kStep, ended);
  tracker.accept({apart(gap, 0.4)}, kStep, kStep, ended);
  return tracker.step_limit();
}

// 0.4 t - t^2 = gap, from where the pipe is on: it turns round after 0.2 s and 40 mm.
TEST(impact_tracker, foresees_the_touch_of_a_pipe_that_slows_down) {
  EXPECT_NEAR(extrapolated(0.03), 0.2 - std::sqrt(0.2 * 0.2 - 0.03), 1e-12);
  EXPECT_GT(extrapolated(0.041), 1e100);
}

TEST(impact_tracker, foresees_no_touch_too_soft_to_matter_and_none_that_is_to_be_captured) {
  ImpactSettings settings;
  settings.min_force = 0.3 * std::sqrt(kStiffness * kMass);  // touches at 0.4 and 0.2 m/s
  EXPECT_LT(extrapolated(0.001, settings), 0.01);
  EXPECT_GT(extrapolated(0.03, settings), 1e100);
  ImpactSettings captured;
  captured.captured = true;
  EXPECT_GT(extrapolated(0.03, captured), 1e100);
}

/// The longest step at `t` while an impact goes on, in parts of the contact time; followed in steps of a hundredth.
double limit_at(double t) {
  const std::vector<BodyRoller> rollers = one_roller();
  const double contact_time = std::numbers::pi * std::sqrt(kMass / kStiffness), h = 0.01 * contact_time;
  ImpactTracker tracker(rollers, {});
  std::vector<EndedImpact> ended;
  for (double current = -1.5 * h; current < t * contact_time; current += h)
    tracker.accept({struck(0.5, current)}, current, h, ended);
  return tracker.step_limit() / contact_time;
}

TEST(impact_tracker, takes_longer_steps_past_the_peak) {
  EXPECT_NEAR(limit_at(0.1), 1.0 / 16.0, 1e-12);
  EXPECT_NEAR(limit_at(0.47), 1.0 / 16.0, 1e-12);
  EXPECT_NEAR(limit_at(0.53), 1.0 / 8.0, 1e-12);
  EXPECT_NEAR(limit_at(0.95), 1.0 / 8.0, 1e-12);
  EXPECT_GT(limit_at(1.05), 1e100);  // it has left
}

ImpactSettings captured() {
  ImpactSettings settings;
  settings.captured = true;
  return settings;
}

TEST(impact_tracker, captured_impacts_leave_the_steps_as_they_are) {
  const std::vector<BodyRoller> rollers = one_roller();
  ImpactTracker tracker(rollers, captured());
  std::vector<EndedImpact> ended;
  const double h = 0.012, gap = 0.005, speed = 0.5;
  tracker.accept({struck(speed, -gap / speed)}, 0.0, h, ended);
  const std::vector<RollerContact> touching = {struck(speed, h - gap / speed)};
  EXPECT_FALSE(tracker.check(touching, h).reject);
  const double before = tracker.step_limit();
  tracker.accept(touching, h, h, ended);
  EXPECT_EQ(tracker.step_limit(), before);
}

TEST(impact_tracker, estimates_the_peak_of_a_captured_impact_from_its_approach) {
  const double speed = 0.5, undamped = speed * std::sqrt(kStiffness * kMass);
  const double contact_time = std::numbers::pi * std::sqrt(kMass / kStiffness);
  for (const double step : {0.3, 0.45, 0.7, 0.9}) {  // in contact times: no step ends at the peak itself
    const std::vector<Impact> impacts = followed(speed, step * contact_time, captured());
    ASSERT_EQ(impacts.size(), 1U) << step;
    EXPECT_NEAR(impacts[0].approach_velocity, speed, 1e-9);
    EXPECT_GE(impacts[0].peak_force, undamped);
    EXPECT_LE(impacts[0].peak_force, 2.0 * undamped);  // what the roller bears after the step comes on top
  }
}

TEST(impact_tracker, a_captured_impact_counts_what_the_other_rollers_of_its_box_bear) {
  std::vector<BodyRoller> rollers(4, one_roller().front());
  rollers[3].box = 1;
  ImpactTracker tracker(rollers, captured());
  std::vector<EndedImpact> ended;
  RollerContact carrying = struck(0.0, 0.0);
  carrying.penetration = 1e-3;
  carrying.normal = 30e3;
  const double h = 0.01, speed = 0.5;
  // Two of a box are struck in the same step, the third bears its load all the time; the fourth is of another box.
  for (int step = 0; step < 20; ++step) {
    const RollerContact roller_contact = struck(speed, (step - 1.5) * h);
    tracker.accept({roller_contact, roller_contact, carrying, carrying}, step * h, h, ended);
  }
  ASSERT_EQ(ended.size(), 2U);
  const RollerContact at_end = struck(speed, 0.5 * h);
  const double estimate = speed * std::sqrt(kStiffness * kMass) + at_end.normal;
  EXPECT_NEAR(ended[0].box_force, 2.0 * estimate + carrying.normal, 1.0);
  EXPECT_NEAR(ended[1].box_force, 2.0 * estimate + carrying.normal, 1.0);
}

TEST(impact_tracker, a_captured_impact_goes_on_where_a_checkpoint_left_it) {
  const std::vector<BodyRoller> rollers = one_roller();
  const double h = 0.005, speed = 0.5;
  ImpactTracker whole(rollers, captured()), resumed(rollers, captured());
  std::vector<EndedImpact> first, second;
  for (double t = -3.5 * h; t < 0.1; t += h) {
    whole.accept({struck(speed, t)}, t, h, first);
    resumed.accept({struck(speed, t)}, t, h, second);
    ImpactTracker next(rollers, captured());
    next.restore(resumed.save());
    resumed = next;
  }
  ASSERT_EQ(first.size(), 1U);
  ASSERT_EQ(second.size(), 1U);
  EXPECT_EQ(first[0].impact.peak_force, second[0].impact.peak_force);
  EXPECT_EQ(first[0].box_force, second[0].box_force);
  EXPECT_EQ(first[0].impact.approach_velocity, second[0].impact.approach_velocity);
}

TEST(impact_tracker, what_lies_on_rollers_at_the_start_has_not_struck_them) {
  const std::vector<BodyRoller> rollers = one_roller();
  ImpactTracker tracker(rollers, {});
  std::vector<EndedImpact> ended;
  RollerContact resting;
  resting.closest.found = true;
  resting.penetration = 1e-3;
  resting.normal = kStiffness * resting.penetration;
  for (int i = 0; i < 100; ++i) tracker.accept({resting}, 0.01 * i, 0.01, ended);
  EXPECT_TRUE(ended.empty());
}

}  // namespace
}  // namespace overbend
