#include "recording/pipe_recorder.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "model/lay_stage.h"
#include "recording/dynamic_findings.h"
#include "support/bgl1_in_time.h"
#include "support/lay_over_bottom_rollers.h"
#include "support/memory_sink.h"
#include "support/stiff_pipe.h"

namespace overbend {
namespace {

using testing::MemorySink;
using testing::TimedLay;

/// The example with a box behind the tensioner, which no pipe passes.
Description with_a_box_out_of_the_way() {
  Description d = testing::workable();
  d.dynamics->duration = 3.0;
  d.dynamics->build_up = 1.0;
  BoxDescription box = d.supports.boxes.front();
  box.name = "behind";
  box.x = d.tensioner.x - 6.0;
  box.incline = 0.0;
  d.supports.boxes.insert(d.supports.boxes.begin(), box);
  return d;
}

TEST(pipe_recorder, a_roller_that_the_pipe_does_not_pass_has_no_separation) {
  const TimedLay c(with_a_box_out_of_the_way());
  EXPECT_GT(c.statics.supports.front().separation, 1.0);  // in statics that of the pipe's end
  MemorySink sink;
  const DynamicResults r = c.results(sink);
  EXPECT_TRUE(std::isnan(r.supports.front().separation.min));
  EXPECT_TRUE(std::isnan(r.supports.front().rollers.front().separation.mean));
  const auto finite = [](double value) { return std::isfinite(value); };
  const std::vector<double> behind = sink.column("support/behind/separation");
  EXPECT_TRUE(std::none_of(behind.begin(), behind.end(), finite));
  for (std::size_t box = 1; box < r.supports.size(); ++box) {
    const std::vector<double> others = sink.column("support/" + r.supports[box].name + "/separation");
    EXPECT_TRUE(std::all_of(others.begin(), others.end(), finite)) << r.supports[box].name;
    EXPECT_TRUE(std::isfinite(r.supports[box].separation.mean));
  }
}

TEST(pipe_recorder, the_smallest_tension_is_that_of_all_stations_at_any_time) {
  const TimedLay c(testing::workable());
  MemorySink sink;
  const DynamicResults r = c.results(sink);
  const double min_value = *std::min_element(r.effective_tension.min.begin(), r.effective_tension.min.end());
  EXPECT_DOUBLE_EQ(r.min_effective_tension.over_time.min, min_value);
  const auto sample = std::find(r.station_s.begin(), r.station_s.end(), r.min_effective_tension.s);
  ASSERT_NE(sample, r.station_s.end());
  EXPECT_DOUBLE_EQ(r.effective_tension.min[static_cast<std::size_t>(sample - r.station_s.begin())], min_value);
  EXPECT_GT(r.min_effective_tension.time, 0.0);
  const std::vector<double> line = sink.column("smallest_tension"), top = sink.column("top_tension_low"),
                            present = sink.column("top_tension");
  EXPECT_LE(*std::min_element(line.begin(), line.end()), min_value);
  for (std::size_t i = 0; i < top.size(); ++i) {
    EXPECT_LE(line[i], top[i]);
    EXPECT_LE(top[i], present[i]);
  }
}

TEST(pipe_recorder, the_size_of_slamming_stands_among_the_assumptions_of_a_run_in_waves) {
  const TimedLay c(testing::workable());
  MemorySink sink;
  const DynamicResults r = c.results(sink);
  const auto says = [](const Assumption& assumption) {
    return assumption.text.find("Slamming") == 0 && assumption.text.find("1.29 kN/m at 1 m/s") != std::string::npos;
  };
  EXPECT_TRUE(std::any_of(r.assumptions.begin(), r.assumptions.end(), says));
}

// Beyond a metre or so the pipe touches no roller, for any motion within a step; but clearances are wanted.
TEST(pipe_recorder, rollers_far_below_the_pipe_have_the_clearance_of_statics) {
  Description d = testing::workable();
  d.environment.waves.front() = {};
  d.vessel.motion = VesselMotion::fixed;
  d.tensioner.range_low.reset();
  d.tensioner.range_high.reset();
  for (BoxDescription& box : d.supports.boxes) box.rows = 1;
  d.dynamics->duration = 1.0;
  d.dynamics->build_up = 0.5;
  double clearance = 0.0;
  for (const double tension : {350e3, 375e3, 400e3, 425e3, 450e3, 500e3, 600e3}) {
    SCOPED_TRACE(tension);
    d.tensioner.tension = tension;
    const TimedLay c(d);
    MemorySink sink;
    const DynamicResults r = c.results(sink);
    ASSERT_GT(c.statics.stinger_tip_clearance.value(), clearance);
    clearance = *c.statics.stinger_tip_clearance;
    EXPECT_NEAR(r.stinger_tip_clearance.min, clearance, 1e-6);
    EXPECT_NEAR(r.stinger_tip_clearance.max, clearance, 1e-6);
    for (std::size_t i = 0; i < r.supports.size(); ++i) {
      EXPECT_NEAR(r.supports[i].separation.max, c.statics.supports[i].separation, 1e-6) << r.supports[i].name;
    }
  }
  EXPECT_GT(clearance, 2.0);
}

// Within 1e-4: in time touchdown is sought between two nodes, of which the lower one lies in the bed.
TEST(pipe_recorder, horizontal_tension_of_a_stiff_pipe_at_rest_is_that_of_statics) {
  Description d = testing::stiff_pipe();
  d.dynamics = DynamicSettings{};
  d.dynamics->duration = 1.0;
  d.dynamics->build_up = 0.5;
  const TimedLay c(d);
  MemorySink sink;
  EXPECT_NEAR(c.results(sink).bottom_tension.mean, c.statics.bottom_tension, 1e-4 * c.statics.bottom_tension);
}

// The edge beyond which the bed falls away bends the pipe most where it lands, between two nodes.
TEST(pipe_recorder, the_sagbend_over_an_edge_of_the_bed_is_bent_as_in_statics) {
  Description d = read_model(OVERBEND_SOURCE_DIR "/validation/bed_cases/BP16-slope.yaml").description.value();
  d.environment.seabed.profile.at(4).depth = 118.0;
  d.dynamics = DynamicSettings{};
  d.dynamics->duration = 1.0;
  d.dynamics->build_up = 0.5;
  const TimedLay c(d);
  MemorySink sink;
  const DynamicResults r = c.results(sink);
  const auto is_as_at_rest = [](const DynamicExtreme& in_time, const Extreme& at_rest) {
    EXPECT_NEAR(in_time.over_time.max, at_rest.value, 2e-3 * at_rest.value);
    EXPECT_NEAR(in_time.s, at_rest.s, 0.1);
  };
  EXPECT_NEAR(c.statics.sagbend.bending_moment.s, c.statics.touchdown.s, 1e-6);
  is_as_at_rest(r.sagbend.bending_moment, c.statics.sagbend.bending_moment);
  is_as_at_rest(r.sagbend.strain, c.statics.sagbend.strain);
}

// Over a roller a cable has a kink, of which the tangent of its elements knows little.
TEST(pipe_recorder, a_cable_leaves_its_last_roller_at_the_angle_of_statics) {
  Description d = read_model(OVERBEND_SOURCE_DIR "/examples/bgl1-abandonment.yaml").description.value();
  d = make_stage_description(d, lay_stages(d).at(2));
  d.environment.waves.front() = {};
  d.vessel.motion = VesselMotion::fixed;
  d.dynamics->duration = 1.0;
  d.dynamics->build_up = 0.5;
  const TimedLay c(d);
  MemorySink sink;
  const DynamicResults r = c.results(sink);
  ASSERT_EQ(c.statics.last_support, "stinger 8");
  EXPECT_NEAR(r.departure_angle.min, c.statics.departure_angle, 1e-5);
  EXPECT_NEAR(r.departure_angle.max, c.statics.departure_angle, 1e-5);
}

TEST(pipe_recorder, compression_in_time_is_warned_of_with_place_time_and_size) {
  DynamicResults r;
  r.min_effective_tension.over_time.min = -8e3;
  r.min_effective_tension.time = 12.5;
  const TimedLay c(testing::workable());
  r.min_effective_tension.s = c.statics.touchdown.s;
  warn_of_slack(c.statics, r);
  ASSERT_EQ(r.findings.size(), 1U);
  EXPECT_NE(messages(r.findings)[0].find("falls to -8.00 kN at t = 12.5 s"), std::string::npos)
      << messages(r.findings)[0];
  EXPECT_NE(messages(r.findings)[0].find("from the tensioner (sagbend)"), std::string::npos) << messages(r.findings)[0];
}

TEST(pipe_recorder, yield_in_time_is_warned_of_with_place_and_size_and_with_the_time_where_that_is_known) {
  DynamicResults r;
  const TimedLay c(testing::workable());
  const double s = c.statics.touchdown.s;
  warn_of_yield(c.statics, {s, 500e6, 414e6}, r);
  r.sagbend.von_mises.s = s;
  r.sagbend.von_mises.time = 12.5;
  r.sagbend.von_mises.over_time.max = 500e6;
  warn_of_yield(c.statics, {s, 500e6, 414e6}, r);
  ASSERT_EQ(r.findings.size(), 2U);
  const std::string place = fmt::format("{:.1f} m from the tensioner (sagbend)", c.statics.total_length - s);
  EXPECT_EQ(
      messages(r.findings)[0].find("the von Mises stress of 500 MPa " + place + " exceeds the yield stress of 414 MPa"),
      0U)
      << messages(r.findings)[0];
  EXPECT_EQ(messages(r.findings)[1].find("the von Mises stress of 500 MPa at t = 12.5 s, " + place), 0U)
      << messages(r.findings)[1];
}

// It lies below the last roller, 19 mm beyond its end: the distance from that end is no clearance of the tip.
TEST(pipe_recorder, a_pipe_under_the_last_roller_has_left_it_and_has_no_clearance_there_as_in_statics) {
  Description d = testing::lay_over_bottom_rollers(0.3);
  d.dynamics = DynamicSettings{};
  d.dynamics->duration = 1.0;
  d.dynamics->build_up = 0.5;
  const TimedLay c(d);
  MemorySink sink;
  const DynamicResults r = c.results(sink);
  EXPECT_TRUE(r.supports.back().left_to_starboard.has_value());
  EXPECT_FALSE(r.supports.front().left_to_starboard || r.supports.front().left_to_port);
  EXPECT_NEAR(r.stinger_tip_clearance.min, c.statics.stinger_tip_clearance.value(), 1e-3);  // nothing moves
  EXPECT_LT(r.stinger_tip_clearance.max, -0.3);
  const auto row = std::ranges::find(r.checks.rows, std::string("tip_clearance"), &CheckRow::id);
  ASSERT_NE(row, r.checks.rows.end());
  EXPECT_EQ(row->status, CheckStatus::exceeded);
}

TEST(pipe_recorder, boxes_that_the_pipe_left_are_reported_in_a_line_for_each_side) {
  DynamicResults r;
  r.supports.resize(4);
  for (std::size_t i = 0; i < 4; ++i) r.supports[i].name = "stinger " + std::to_string(i + 1);
  r.supports[1].left_to_port = 9.25;
  r.supports[2].left_to_port = 7.5;
  r.supports[3].left_to_port = 3.0;
  r.supports[0].left_to_starboard = 40.0;
  warn_of_left_boxes(r);
  const std::vector<std::string> reported = {
      "the pipe left 'stinger 4' and 2 more boxes over their sides to port, the first at t = 3.0 s, the last at t = "
      "9.2 s",
      "the pipe left 'stinger 1' over its side to starboard at t = 40.0 s"};
  EXPECT_EQ(messages(r.findings), reported);
}

}  // namespace
}  // namespace overbend
