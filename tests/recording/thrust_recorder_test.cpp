#include "recording/thrust_recorder.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "support/allocation_count.h"

namespace overbend {
namespace {

Hull positioned() {
  Hull hull;
  StationKeeping& keeping = hull.station_keeping.emplace();
  keeping.law.stiffness = Vec3(120e3, 90e3, 2e8);
  keeping.law.damping = Vec3(2e6, 0.0, 0.0);
  keeping.law.limit = Vec3(1e300, 45e3, 4e6);
  return hull;
}

SystemState at(double time, const Vec3& place, const Vec3& rate = Vec3::Zero()) {
  SystemState state;
  state.time = time;
  state.bodies.resize(1);
  state.bodies.front().slow = {place, rate};
  return state;
}

// A sway of 1 m asks for 90 kN times its sine: more than half of that in two thirds of the time.
TEST(thrust_watch, counts_the_time_in_which_more_is_asked_for_than_there_is) {
  constexpr int kSteps = 3600;
  const Hull hull = positioned();
  ThrustRecorder watch(&hull);
  watch.start(at(-1.0, Vec3(0.0, 5.0, 0.0)));
  watch.add(at(0.0, Vec3(0.0, 5.0, 0.0)), 1.0);  // of the build-up: does not count
  SystemState state = at(0.0, Vec3::Zero());
  const auto before = testing::allocation_count();
  for (int i = 1; i <= kSteps; ++i) {
    state.time = 0.25 * i;
    state.bodies.front().slow.value.y() = std::sin(2.0 * std::numbers::pi * (i - 0.5) / kSteps);
    watch.add(state, 0.25);
  }
  EXPECT_EQ(testing::allocation_count(), before);
  const std::vector<ThrustDynamics> thrust = watch.results();
  ASSERT_EQ(thrust.size(), 3U);
  EXPECT_EQ(thrust[1].name, "sway");
  EXPECT_NEAR(thrust[1].time_at_limit, 600.0, 0.5);
  EXPECT_NEAR(thrust[1].max_demand, 90e3, 1.0);
  EXPECT_EQ(thrust[1].given.max, 45e3);
  EXPECT_EQ(thrust[1].given.min, -45e3);
  EXPECT_NEAR(thrust[1].given.mean, 0.0, 1.0);
  // Mean square of a sine cut at half its height: 2/pi (integral of sin^2 to pi/6) + 1/4 * 2/3.
  const double square = 2.0 / std::numbers::pi * (std::numbers::pi / 12.0 - std::sqrt(3.0) / 8.0) + 1.0 / 6.0;
  EXPECT_NEAR(thrust[1].given.std, 90e3 * std::sqrt(square), 5.0);
  EXPECT_FALSE(thrust[0].limit);
  EXPECT_EQ(thrust[0].time_at_limit, 0.0);
  ASSERT_EQ(watch.findings().size(), 1U);
  EXPECT_NE(
      watch.findings()[0].message.find("at its limit in sway for 600 s, 67 % of the run: the demand is up to 90 kN, "
                                       "the limit 45 kN (station_keeping.dp.sway.thrust_limit)"),
      std::string::npos)
      << watch.findings()[0].message;
}

TEST(thrust_watch, is_along_the_slow_heading_with_the_damper_on_the_slow_rate) {
  const Hull hull = positioned();
  ThrustRecorder watch(&hull);
  // Bow turned to port by a right angle: what lies ahead in W is to starboard of it.
  watch.add(at(1.0, Vec3(0.3, -0.5, std::numbers::pi / 2.0), Vec3(0.0, 0.02, 0.0)), 1.0);
  EXPECT_NEAR(watch.given(0), 120e3 * 0.5 - 2e6 * 0.02, 1e-6);
  EXPECT_NEAR(watch.given(1), 90e3 * 0.3, 1e-6);
  EXPECT_EQ(watch.given(2), -4e6);  // of 314 MN m that are asked for
}

TEST(thrust_watch, comes_back_from_a_checkpoint_and_is_silent_without_dynamic_positioning) {
  const Hull hull = positioned(), moored;
  ThrustRecorder watch(&hull), again(&hull), none(&moored);
  watch.add(at(1.0, Vec3(0.1, 0.0, 0.0)), 1.0);
  again.restore(watch.save());
  EXPECT_EQ(again.results()[0].given.min, -12e3);
  none.start(at(-1.0, Vec3::Zero()));
  none.add(at(1.0, Vec3::Zero()), 1.0);
  EXPECT_TRUE(none.results().empty());
  EXPECT_TRUE(ThrustRecorder(nullptr).findings().empty());
}

}  // namespace
}  // namespace overbend
