#include <gtest/gtest.h>

#include "dynamics/setup/unsupported_in_dynamics.h"
#include "modelfile/reading/yaml_reader.h"
#include "support/bgl1_in_time.h"

namespace overbend {
namespace {

using testing::workable;

TEST(unsupported_in_dynamics, says_why_a_model_has_statics_but_no_dynamic_analysis) {
  Description d = workable();
  d.dynamics.reset();
  EXPECT_TRUE(unsupported_in_dynamics(build_model(d)));
  d = workable();
  d.vessel.motion = VesselMotion::coupled;
  EXPECT_TRUE(unsupported_in_dynamics(build_model(d)));
  d = workable();
  d.tensioner.tension = 300e3;
  EXPECT_TRUE(unsupported_in_dynamics(build_model(d)));
  EXPECT_FALSE(unsupported_in_dynamics(build_model(workable())));
}

TEST(unsupported_in_dynamics, of_a_hull_on_moorings_alone_is_what_it_is_of_a_lay) {
  const Description moored = read_model(OVERBEND_SOURCE_DIR "/examples/moored-barge.yaml").description.value();
  EXPECT_FALSE(unsupported_in_dynamics(build_model(moored)));
  Description d = moored;
  d.vessel.coupled->data.reset();
  EXPECT_TRUE(unsupported_in_dynamics(build_model(d)));
  d = moored;
  d.moorings.reset();
  const std::optional<StaticFailure> unsupported = unsupported_in_dynamics(build_model(d));
  ASSERT_TRUE(unsupported);
  EXPECT_TRUE(unsupported->input);
  EXPECT_EQ(unsupported->what, "the floating hull has no horizontal restraint");
}

TEST(unsupported_in_dynamics, lets_a_prescribed_vessel_move_ahead_but_not_at_once) {
  Description d = workable();
  d.operation.type = OperationType::pull_ahead;
  EXPECT_FALSE(unsupported_in_dynamics(build_model(d)));
  d.operation.acceleration_time = 0.0;
  const std::optional<StaticFailure> unsupported = unsupported_in_dynamics(build_model(d));
  ASSERT_TRUE(unsupported);
  EXPECT_EQ(unsupported->key, "operation.acceleration_time");
}

TEST(unsupported_in_dynamics, lets_a_prescribed_vessel_start_in_full_motion_only_where_statics_leave_it) {
  Description d = workable();
  d.dynamics->build_up = 0.0;
  d.environment.waves.front().hs = 4.0;
  const std::optional<StaticFailure> unsupported = unsupported_in_dynamics(build_model(d));
  ASSERT_TRUE(unsupported);
  EXPECT_EQ(unsupported->key, "analysis.dynamic.build_up");
  EXPECT_NE(unsupported->why.find("the stern shoe jumps by"), std::string::npos) << unsupported->why;
  d.vessel.motion = VesselMotion::harmonic;
  d.vessel.harmonic["heave"] = {0.5, 10.0, 0.0};  // passes its mean at t = 0
  EXPECT_FALSE(unsupported_in_dynamics(build_model(d)));
  d.vessel.harmonic["heave"].phase = 0.5;
  EXPECT_TRUE(unsupported_in_dynamics(build_model(d)));
  d.vessel.harmonic["heave"].amplitude = 0.1;  // a small leap is reported
  EXPECT_FALSE(unsupported_in_dynamics(build_model(d)));
  d.vessel.motion = VesselMotion::fixed;
  EXPECT_FALSE(unsupported_in_dynamics(build_model(d)));
}

TEST(unsupported_in_dynamics, is_a_record_that_ends_before_the_last_row_of_the_run) {
  Description d = workable();
  d.vessel.motion = VesselMotion::history;
  d.vessel.history.emplace();
  for (int i = 0; i <= 61; ++i) {
    d.vessel.history->time.push_back(0.2 * i);
    d.vessel.history->freedoms.push_back({});
  }
  d.dynamics->duration = 12.0;
  EXPECT_FALSE(unsupported_in_dynamics(build_model(d)));
  d.dynamics->duration = 12.2;  // of the whole record: the last row is at 12.5 s
  const std::optional<StaticFailure> unsupported = unsupported_in_dynamics(build_model(d));
  ASSERT_TRUE(unsupported);
  EXPECT_EQ(unsupported->key, "vessel.motion.history");
  EXPECT_NE(unsupported->why.find("the run from 0 s to 12.5 s"), std::string::npos) << unsupported->why;
  d.dynamics->output_step = 0.2;
  EXPECT_FALSE(unsupported_in_dynamics(build_model(d)));
}

}  // namespace
}  // namespace overbend
