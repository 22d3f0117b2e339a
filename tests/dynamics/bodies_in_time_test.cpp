/// Lines on bodies that move by themselves, in time: against a closed form and against ends that move alike.
#include <gtest/gtest.h>

#include "hull/pose_shift.h"
#include "statics/moored/moored_lay.h"
#include "support/line_cases.h"
#include "support/lines_for_moorings.h"

namespace overbend {
namespace {

DynamicOptions options_for(double duration, double build_up) {
  DynamicOptions options;
  options.duration = duration;
  options.build_up = build_up;
  options.output_step = 0.1;
  options.max_step = 0.05;
  return options;
}

BodyDescription tug_that_surges(const Vec3& place, double amplitude, double period) {
  BodyDescription tug;
  tug.name = "tug";
  tug.place = place;
  tug.hull.heading = 0.5 * std::numbers::pi;  // the bow to the east: V along W
  tug.hull.motion = VesselMotion::harmonic;
  tug.hull.harmonic["surge"] = {amplitude, period, 0.0};
  return tug;
}

LineEndDescription on_tug(const Vec3& point) {
  LineEndDescription end;
  end.kind = LineEndKind::body;
  end.body = "tug";
  end.at = point;
  return end;
}

/// Range of values from a time on.
double half_range(const testing::LineHistory& line, const std::vector<double>& values, double from) {
  double min_value = 1e300, max_value = -1e300;
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (line.time[i] < from) continue;
    min_value = std::min(min_value, values[i]);
    max_value = std::max(max_value, values[i]);
  }
  return 0.5 * (max_value - min_value);
}

TEST(line_on_a_tug, swings_as_with_an_end_of_the_same_prescribed_motion) {
  Description d = testing::chain_case(50.0, 0.0);
  d.lines[0].second.amplitude = Vec3(2.0, 0.0, 0.0);
  d.lines[0].second.period = 10.0;
  const testing::LineHistory prescribed = testing::run_lines(d, options_for(10.0, 10.0)).front();
  d.lines[0].second.amplitude = Vec3::Zero();
  d.lines[0].second.period = 0.0;
  d.bodies = {tug_that_surges(Vec3(12.0, -7.0, 0.0), 2.0, 10.0)};
  d.lines[0].second = on_tug(Vec3(-12.0, 7.0, 0.0));
  const testing::LineHistory transported = testing::run_lines(d, options_for(10.0, 10.0)).front();
  ASSERT_EQ(transported.last.size(), prescribed.last.size());
  // The same motion: left is the rounding of places, over a chain's stiffness, and what steps make of it.
  for (std::size_t i = 0; i < prescribed.last.size(); ++i) {
    EXPECT_NEAR(transported.last[i], prescribed.last[i], 1e-4 * prescribed.max_last_tension) << prescribed.time[i];
  }
}

TEST(line_on_a_body_that_stays, swings_not_at_all) {
  Description d = testing::chain_case(50.0, 0.0);
  d.bodies = {tug_that_surges(Vec3::Zero(), 0.0, 10.0)};
  d.lines[0].second = on_tug(Vec3::Zero());
  const testing::LineHistory line = testing::run_lines(d, options_for(5.0, 5.0)).front();
  EXPECT_NEAR(line.max_last_tension, line.min_last_tension, 1e-6 * line.max_last_tension);
}

/// A mass in the middle of a taut rope between a wall and a tug: two springs, m u'' = k (X - u) - k u.
TEST(mass_on_a_hawser, is_the_oscillator_that_two_springs_make_of_it) {
  constexpr double kLength = 100.0, kEA = 2e6, kMass = 2000.0, kAmplitude = 0.2, kPeriod = 2.0;
  Description d = testing::water_alone(1025.0, 100.0);
  LineTypeDescription rope = testing::cable_type(0.05, 0.01, kEA, 0.0, 1025.0);
  rope.drag_normal = rope.drag_axial = rope.added_mass_normal = rope.added_mass_axial = 0.0;
  rope.weight_submerged = 0.0;
  d.bodies = {tug_that_surges(Vec3(1.0, 0.0, 0.0), kAmplitude, kPeriod)};
  d.lines = {testing::free_line(rope, kLength, Vec3(-kLength, 0.0, -50.0), Vec3::Zero())};
  d.lines[0].second = on_tug(Vec3(0.0, 0.0, -50.0));  // a metre further than the rope is long: 20 kN
  LinePointDescription mass;
  mass.kind = PointKind::clump;
  mass.at = 0.5 * kLength;
  mass.mass = kMass;
  mass.volume = kMass / 1025.0;
  d.lines[0].points = {mass};
  const testing::LineHistory line = testing::run_lines(d, options_for(40.0, 60.0)).front();
  const double k = kEA / (0.5 * kLength), omega = 2.0 * std::numbers::pi / kPeriod;
  const double share = k / (2.0 * k - kMass * omega * omega);  // u over X
  EXPECT_NEAR(half_range(line, line.first, 20.0), std::abs(k * share * kAmplitude), 0.02 * k * kAmplitude);
  EXPECT_NEAR(half_range(line, line.last, 20.0), std::abs(k * (1.0 - share) * kAmplitude), 0.02 * k * kAmplitude);
}

TEST(bodies_in_time, are_reported_with_their_motion_and_the_pull_of_lines) {
  Description d = testing::chain_case(50.0, 0.0);
  d.bodies = {tug_that_surges(Vec3::Zero(), 2.0, 10.0)};
  d.lines[0].second = on_tug(Vec3::Zero());
  const testing::RestingLines rest(d);
  const DynamicOptions options = options_for(20.0, 10.0);
  Simulation run(rest.model, rest.start(options), options);
  StaticResults statics;
  statics.lines.resize(1);
  testing::MemorySink sink;
  Recorder recorder(rest.model, statics, run, sink);
  run.observe(recorder);
  ASSERT_TRUE(run.advance(run.end()));
  DynamicResults results;
  recorder.fill(results);
  ASSERT_EQ(results.bodies.size(), 1U);
  const BodyDynamics& tug = results.bodies[0];
  EXPECT_NEAR(tug.surge.max, 2.0, 1e-3);
  EXPECT_NEAR(tug.surge.min, -2.0, 1e-3);
  EXPECT_NEAR(tug.surge.std, 2.0 / std::numbers::sqrt2, 0.02);
  EXPECT_NEAR(tug.heave.max, 0.0, 1e-12);
  const std::vector<double> surge = sink.column("body/tug/surge"), pull = sink.column("body/tug/pull");
  const std::vector<double> time = sink.column("time"), tension = sink.column("line/line/second_tension");
  for (std::size_t i = 0; i < time.size(); ++i) {
    if (time[i] < 0.0) continue;
    EXPECT_NEAR(surge[i], 2.0 * std::sin(0.2 * std::numbers::pi * time[i]), 1e-9);
    EXPECT_GT(pull[i], 0.0);
    EXPECT_LE(pull[i], 1.05 * tension[i]);
  }
  EXPECT_GT(tug.pull.max, tug.pull.mean);
}

/// Its pose at the end of a short run in waves.
VesselPose pose_in_waves(const Description& d, const Model& model, const ModelEquilibrium& rest) {
  DynamicOptions options = dynamic_options(model);
  options.duration = 6.0;
  options.build_up = 6.0;
  options.output_step = 0.5;
  options.seed = d.environment.waves.front().seed;
  Simulation run(model, *rest.solution, 0.0, options);
  EXPECT_TRUE(run.advance(run.end())) << run.failure()->what;
  return run.present().vessel().pose;
}

TEST(hull_on_lines, goes_in_waves_as_on_mooring_lines) {
  const Description d = testing::pushed_barge();
  Model moored = build_model(d);
  const ModelEquilibrium catenaries = solve_equilibrium(moored);
  const Description alone = testing::on_lines(d, catenaries.moorings->rest.moorings);
  Model lines = build_model(alone);
  const ModelEquilibrium elements = solve_equilibrium(lines);
  ASSERT_FALSE(elements.failure);
  const auto wanted = shift_between(moored.nominal_pose, pose_in_waves(d, moored, catenaries));
  const auto found = shift_between(lines.nominal_pose, pose_in_waves(alone, lines, elements));
  // Two meshes of the lines, and steps that their errors choose; the hull heaves and surges by decimetres.
  for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(found[k], wanted[k], 3e-3) << k;
  for (std::size_t k = 3; k < 6; ++k) EXPECT_NEAR(found[k], wanted[k], 5e-5) << k;
  EXPECT_GT(std::abs(wanted[4]), 5e-4);
}

}  // namespace
}  // namespace overbend
