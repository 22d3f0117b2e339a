/// A prescribed motion that begins at once.
#include "dynamics/setup/initial_jump.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>

#include "support/bgl1_in_time.h"
#include "support/memory_sink.h"

namespace overbend {
namespace {

/// Heave of 5 cm, at its crest at t = 0.
Description lifted_at_once() {
  Description d = testing::workable();
  d.environment.waves.front().type = WaveType::none;
  d.dynamics->build_up = 0.0;
  d.dynamics->duration = 0.5;
  d.vessel.motion = VesselMotion::harmonic;
  d.vessel.harmonic.clear();
  d.vessel.harmonic["heave"] = {0.05, 10.0, 0.5 * std::numbers::pi};
  return d;
}

TEST(start_leap, is_the_way_from_statics_to_where_a_prescribed_motion_begins) {
  Description d = lifted_at_once();
  EXPECT_NEAR(initial_shoe_jump(build_model(d)), 0.05, 1e-12);
  d.vessel.harmonic["heave"].phase = 0.0;
  EXPECT_NEAR(initial_shoe_jump(build_model(d)), 0.0, 1e-12);
  d = lifted_at_once();
  d.dynamics->build_up = 10.0;
  EXPECT_EQ(initial_shoe_jump(build_model(d)), 0.0);
}

TEST(start_leap, may_be_one_of_speed_alone) {
  Description d = lifted_at_once();
  EXPECT_NEAR(initial_shoe_speed(build_model(d)), 0.0, 1e-12);
  d.vessel.harmonic["heave"].phase = 0.0;  // passes its mean at t = 0
  EXPECT_NEAR(initial_shoe_speed(build_model(d)), 0.05 * 2.0 * std::numbers::pi / 10.0, 1e-12);
  const testing::TimedLay c(d);
  testing::EmptySink sink;
  const std::vector<std::string> warnings = messages(c.results(sink).findings);
  EXPECT_TRUE(std::ranges::any_of(warnings, [](const std::string& message) {
    return message.find("the stern shoe starts with 0.0314 m/s") != std::string::npos;
  }));
  d.dynamics->build_up = 10.0;
  EXPECT_EQ(initial_shoe_speed(build_model(d)), 0.0);
}

TEST(start_leap, of_centimetres_is_reported_by_the_run) {
  const testing::TimedLay c(lifted_at_once());
  testing::EmptySink sink;
  const std::vector<std::string> warnings = messages(c.results(sink).findings);
  EXPECT_TRUE(std::ranges::any_of(
      warnings, [](const std::string& message) { return message.find("jumps by 0.05 m") != std::string::npos; }));
}

}  // namespace
}  // namespace overbend
