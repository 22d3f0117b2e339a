/// A hull that dynamic positioning holds, with a pipe and without, at rest and in time.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <utility>

#include "dynamics/run/simulation.h"
#include "recording/run_dynamics.h"
#include "recording/vessel_recorder.h"
#include "statics/recovery/recovery.h"
#include "support/memory_sink.h"
#include "support/moored_lay.h"

namespace overbend {
namespace {

using testing::coarse_example;
using testing::SolvedHull;
using testing::SolvedLay;

constexpr double kSurge = 120e3, kSway = 90e3, kYaw = 2e8;  // [N/m, N/m, N m]

Description positioned(double duration) {
  Description d = coarse_example("bgl1-moored", duration, 0.0);
  d.moorings.reset();
  d.environment.waves.front().type = WaveType::none;
  d.environment.current.clear();
  d.station_keeping = StationKeepingDescription{};
  d.station_keeping->stiffness = Vec3(kSurge, kSway, kYaw);
  d.station_keeping->damping = Vec3(2e6, 2e6, 3e9);
  return d;
}

Description without_pipe(double duration) {
  Description d = positioned(duration);
  d.has_pipe = false;
  return d;
}

/// F = k x in each direction, with a moment that the pull at a side makes about the centre of gravity.
TEST(positioned_hull, gives_way_by_force_over_stiffness) {
  Description d = without_pipe(1.0);
  d.vessel.loads = {{"tug", Vec3(0.0, 10.0, 0.0), Vec3(240e3, -45e3, 0.0), Vec3::Zero()}};
  const MooredState rest = SolvedHull(d).rest.moorings->rest;
  const double turn = -rest.thrust[2] / kYaw;
  EXPECT_NEAR(rest.vessel.yaw, turn, 1e-12);
  EXPECT_NEAR(rest.thrust[2], 10.0 * 240e3 * std::cos(turn) - 10.0 * 45e3 * std::sin(turn), 1.0);
  // Thrust along the hull, offset along the hull as drawn.
  EXPECT_NEAR(rest.thrust[0] * std::cos(turn) - rest.thrust[1] * std::sin(turn), -240e3, 1.0);
  EXPECT_NEAR(rest.thrust[0] * std::sin(turn) + rest.thrust[1] * std::cos(turn), 45e3, 1.0);
  EXPECT_NEAR(-rest.thrust[0] / kSurge, rest.vessel.surge * std::cos(turn) + rest.vessel.sway * std::sin(turn), 1e-4);
  EXPECT_NEAR(rest.thrust[1] / kSway, rest.vessel.surge * std::sin(turn) - rest.vessel.sway * std::cos(turn), 1e-4);
  EXPECT_LT(rest.residual, 1e-8);
}

/// 2 pi sqrt((m + a)/k), with the added mass of the hull's file at its lowest frequency.
TEST(positioned_hull, swings_with_the_period_of_its_mass_on_that_stiffness) {
  const SolvedHull hull(without_pipe(1.0));
  const CoupledHullDescription& floats = *hull.model.description.vessel.coupled;
  const double added = floats.data->radiation.front().added_mass(0, 0);
  const double expected = 2.0 * std::numbers::pi * std::sqrt((floats.mass + added) / kSurge);
  double found = 0.0;
  for (const PeriodResult& period : hull.rest.moorings->rest.vessel.natural_periods) {
    if (period.mode == "surge") found = period.period;
  }
  EXPECT_NEAR(found, expected, 0.01 * expected);
}

TEST(positioned_hull, is_rejected_where_its_thrusters_cannot_hold_it) {
  Description d = without_pipe(1.0);
  d.station_keeping->limit = Vec3(100e3, 1e300, 1e300);
  d.vessel.loads = {{"tug", Vec3::Zero(), Vec3(101e3, 0.0, 0.0), Vec3::Zero()}};
  Model model = build_model(d);
  const ModelEquilibrium outcome = solve_moored_hull(model);
  ASSERT_TRUE(outcome.failure);
  EXPECT_NE(outcome.failure->why.find("thrust limit"), std::string::npos) << outcome.failure->why;
  StationKeepingDescription& law = *d.station_keeping;
  const double surge = std::exchange(law.stiffness.x(), 0.0);
  Model unheld = build_model(d);
  EXPECT_NE(solve_moored_hull(unheld).failure->why.find("nothing holds it in surge"), std::string::npos);
  law.stiffness.x() = surge;
  d.vessel.loads.front().force.x() = 99e3;
  EXPECT_NEAR(SolvedHull(d).rest.moorings->rest.vessel.surge, 99e3 / kSurge, 1e-6);
}

/// Lines and thrusters in parallel: stiffnesses add, and the load is shared by them.
TEST(positioned_hull, shares_a_load_with_mooring_lines) {
  Description d = coarse_example("bgl1-moored", 1.0, 0.0);
  d.environment.waves.front().type = WaveType::none;
  d.environment.current.clear();
  d.has_pipe = false;
  d.vessel.loads = {{"tug", Vec3::Zero(), Vec3(50e3, 0.0, 0.0), Vec3::Zero()}};
  d.moorings->find = FindMooring::pose;
  const MooredState moored = SolvedHull(d).rest.moorings->rest;
  d.station_keeping = positioned(1.0).station_keeping;
  const MooredState both = SolvedHull(d).rest.moorings->rest;
  EXPECT_NEAR(both.thrust[0] + both.mooring_force[0], -50e3, 1.0);
  EXPECT_NEAR(both.thrust[0], -kSurge * both.vessel.surge, 1.0);
  EXPECT_LT(both.vessel.surge, moored.vessel.surge);
  EXPECT_NEAR(both.vessel.stiffness[0] - both.mooring_stiffness[0], kSurge, 1.0);
}

TEST(positioned_hull, stays_in_calm_water_where_statics_put_it_with_its_pipe) {
  const SolvedLay lay(positioned(20.0));
  ASSERT_FALSE(lay.lay.failure) << lay.lay.failure->why;
  const MooredState& rest = lay.lay.moorings->rest;
  // The pipe pulls it astern: the tension at touchdown, for no water flows.
  const double pull = recover_statics(lay.model, *lay.lay.solution).bottom_tension;
  EXPECT_NEAR(rest.thrust[0], pull, 2e-3 * pull);  // the pipe is not quite level where it touches the bed
  Simulation run(lay.model, *lay.lay.solution, lay.tension(), dynamic_options(lay.model));
  ASSERT_FALSE(run.failure());
  while (!run.finished()) ASSERT_TRUE(run.step());
  const auto shift = shift_between(lay.model.nominal_pose, run.present().vessel().pose);
  EXPECT_NEAR(shift[0], rest.vessel.surge, 1e-3);
  EXPECT_NEAR(shift[1], rest.vessel.sway, 1e-3);
}

/// Against a steady pull, the thrust of a run is that of statics, in statistics and in every row.
TEST(positioned_hull, reports_its_thrust_in_time) {
  Description d = without_pipe(10.0);
  d.vessel.loads = {{"tug", Vec3::Zero(), Vec3(240e3, -45e3, 0.0), Vec3::Zero()}};
  d.station_keeping->limit = Vec3(400e3, 1e300, 1e300);
  const SolvedHull hull(d);
  const std::vector<double>& rest = hull.rest.moorings->rest.thrust;
  testing::MemorySink sink;
  const auto go_on = [](const DynamicProgress&) { return DynamicControl::go_on; };
  const DynamicResults run =
      run_dynamics(hull.model, hull.start(), {}, dynamic_options(hull.model), sink, nullptr, go_on).results.value();
  ASSERT_EQ(run.thrust.size(), 3U);
  for (std::size_t i = 0; i < 3; ++i) {
    const SummaryStatistics& given = run.thrust[i].given;
    EXPECT_NEAR(given.mean, rest[i], 1.0) << i;
    EXPECT_NEAR(given.min, rest[i], 2.0) << i;
    EXPECT_NEAR(given.max, rest[i], 2.0) << i;
    for (const double value : sink.column("thrust/" + run.thrust[i].name)) EXPECT_NEAR(value, rest[i], 2.0);
  }
  EXPECT_EQ(run.thrust[0].limit, 400e3);
  EXPECT_EQ(run.thrust[0].time_at_limit, 0.0);
}

TEST(positioned_hull, at_rest_does_not_drift_by_its_rounding) {
  const SolvedHull hull(without_pipe(20.0));
  Simulation run(hull.model, hull.start(), 0.0, dynamic_options(hull.model));
  ASSERT_FALSE(run.failure());
  EXPECT_TRUE(run.advance(run.end()));
  EXPECT_LT(std::abs(run.energy().drift()), 1e-9);  // of what it weighs, moved by a thousandth of a millimetre
}

TEST(positioned_hull, is_pulled_ahead_by_its_wanted_place) {
  Description d = without_pipe(400.0);
  d.vessel.loads = {{"tug", Vec3::Zero(), Vec3(-60e3, 0.0, 0.0), Vec3::Zero()}};
  d.vessel.coupled->low_frequency_period = 5.0;  // thrust that hardly lags
  d.operation.type = OperationType::pull_ahead;
  d.operation.distance = 12.0;
  d.operation.start = 10.0;
  const SolvedHull hull(d);
  const MooringResults& results = *hull.rest.moorings;
  ASSERT_EQ(results.stages.size(), 2U);
  EXPECT_NEAR(results.stages[1].vessel.surge - results.stages[0].vessel.surge, 12.0, 1e-6);
  EXPECT_NEAR(results.stages[1].thrust[0], 60e3, 1.0);
  Simulation run(hull.model, hull.start(), 0.0, dynamic_options(hull.model));
  ASSERT_FALSE(run.failure());
  EXPECT_TRUE(run.advance(run.end()));
  const auto shift = shift_between(hull.model.nominal_pose, run.present().assembly->surroundings().bodies[0].pose);
  EXPECT_NEAR(shift[0], results.stages[1].vessel.surge, 0.05);  // what is left of the swing
}

}  // namespace
}  // namespace overbend
