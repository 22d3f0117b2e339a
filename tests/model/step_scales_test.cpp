#include "model/step_scales.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "support/fixtures.h"
#include "support/line_cases.h"

namespace overbend {
namespace {

/// A pipe of 0.4 m in waves of `period`.
Model pipe_in_waves(double period, double scale = 1.0) {
  Description d = testing::plain_description();
  d.environment.waves.front().type = WaveType::airy;
  d.environment.waves.front().period = period;
  Model model = build_model(d);
  Section& pipe = model.sections.front();
  pipe.outer_diameter = 0.4 * scale;
  pipe.EI = 1e8 * std::pow(scale, 5);
  pipe.weight_in_air = 3e3 * scale * scale;
  return model;
}

TEST(step_scales, of_usual_pipes_in_usual_waves_are_round) {
  const StepScales scales = step_scales(pipe_in_waves(8.0));
  EXPECT_EQ(scales.time, 0.125);
  EXPECT_EQ(scales.length, 1e-3);
  EXPECT_EQ(scales.force, 1e3);
}

TEST(step_scales, of_small_models_follow_froudes_law) {
  const StepScales tenth = step_scales(pipe_in_waves(8.0 * std::sqrt(0.1), 0.1)),
                   fiftieth = step_scales(pipe_in_waves(8.0 * std::sqrt(0.02), 0.02));
  EXPECT_NEAR(fiftieth.time / tenth.time, std::sqrt(0.2), 1e-12);
  EXPECT_NEAR(fiftieth.length / tenth.length, 0.2, 1e-12);
  EXPECT_NEAR(fiftieth.force / tenth.force, std::pow(0.2, 3), 1e-12);
}

TEST(step_scales, of_lines_by_themselves_follow_their_length) {
  Description d = testing::chain_case(50.0, 2.0);
  EXPECT_DOUBLE_EQ(step_scales(build_model(d)).length, 1e-3);
  d.lines[0].segments[0].length.value() *= 0.02;
  EXPECT_NEAR(step_scales(build_model(d)).length, 2e-5, 1e-6);
}

TEST(step_scales, follow_the_shortest_period_that_is_prescribed) {
  Description d = testing::chain_case(50.0, 2.0);
  d.lines[0].second.period = 2.0;
  EXPECT_DOUBLE_EQ(step_scales(build_model(d)).time, 0.04);
  d.lines[0].second.amplitude = Vec3::Zero();  // is at rest
  EXPECT_DOUBLE_EQ(step_scales(build_model(d)).time, 0.125);
  d.vessel.harmonic["heave"] = {1.0, 5.0, 0.0};
  EXPECT_DOUBLE_EQ(step_scales(build_model(d)).time, 0.1);
  d.environment.waves.front().type = WaveType::user;
  d.environment.waves.front().spectrum = {{2.0, 0.0}, {3.0, 1.0}, {4.0, 0.0}};
  EXPECT_NEAR(step_scales(build_model(d)).time, 2.0 * std::numbers::pi / 3.0 / 50.0, 1e-12);
}

}  // namespace
}  // namespace overbend
