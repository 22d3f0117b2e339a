/// BGL-1 afloat under its pipe on eight mooring lines of elements.
#include "dynamics/setup/mooring_lines.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "dynamics/run/simulation.h"
#include "dynamics/setup/unsupported_in_dynamics.h"
#include "recording/vessel_recorder.h"
#include "support/line_cases.h"
#include "support/moored_lay.h"

namespace overbend {
namespace {

Description moored() {
  return testing::coarse_example("bgl1-moored", 1.0, 2.0);
}

double fairlead_tension(const Simulation& simulation, std::size_t line) {
  const std::array<double, 6>& force = simulation.present().assembly->line(line).end_force(LineEnd::last);
  return Vec3(force[0], force[1], force[2]).norm();
}

TEST(mooring_lines, hold_the_barge_in_calm_water_with_the_tensions_of_the_catenaries) {
  Description d = moored();
  d.environment.waves.front().type = WaveType::none;
  d.environment.current.clear();
  const testing::SolvedLay solved_lay(d);
  ASSERT_FALSE(solved_lay.lay.failure) << solved_lay.lay.failure->why;
  ASSERT_FALSE(unsupported_in_dynamics(solved_lay.model));
  Simulation simulation(solved_lay.model, *solved_lay.lay.solution, solved_lay.tension(),
                        dynamic_options(solved_lay.model));
  ASSERT_FALSE(simulation.failure()) << simulation.failure()->what;
  ASSERT_EQ(simulation.moorings().size(), 8u);
  const HullState first = simulation.present().state->bodies.at(0);
  EXPECT_LT(first.acc.head<3>().norm(), 1e-6 * kGravity);
  EXPECT_LT(first.h.head<2>().norm(), 0.02);  // as drawn, but for elements in place of catenaries
  for (std::size_t i = 0; i < 8; ++i) {
    const double catenary = solved_lay.lay.moorings->rest.moorings[i].fairlead_tension;
    EXPECT_NEAR(fairlead_tension(simulation, i + 1), catenary, 0.001 * catenary) << i;
  }
  while (simulation.step()) {
  }
  ASSERT_FALSE(simulation.failure());
  EXPECT_LT((simulation.present().state->bodies[0].h - first.h).norm(), 1e-5);
}

/// Lines and pipe pull it down by 0.026 m and heel and trim it, in time as in statics: once.
TEST(mooring_lines, sink_a_barge_that_is_not_ballasted_for_them_as_in_statics) {
  Description d = moored();
  d.environment.waves.front().type = WaveType::none;
  d.environment.current.clear();
  d.vessel.coupled->ballast = Ballast::as_given;
  const testing::SolvedLay solved_lay(d);
  ASSERT_FALSE(solved_lay.lay.failure) << solved_lay.lay.failure->why;
  const VesselResult& statics = solved_lay.lay.moorings->rest.vessel;
  EXPECT_NEAR(statics.heave, -0.026, 0.002);
  const Simulation simulation(solved_lay.model, *solved_lay.lay.solution, solved_lay.tension(),
                              dynamic_options(solved_lay.model));
  ASSERT_FALSE(simulation.failure()) << simulation.failure()->what;
  const auto shift = shift_between(solved_lay.model.nominal_pose, simulation.present().vessel().pose);
  EXPECT_NEAR(shift[2], statics.heave, 0.01 * std::abs(statics.heave));
  EXPECT_NEAR(shift[4], statics.pitch, 0.03 * std::abs(statics.pitch));
}

TEST(mooring_lines, let_the_barge_start_at_rest_under_the_mean_drift_of_its_sea) {
  Description d = moored();
  d.environment.current.clear();
  const testing::SolvedLay solved_lay(d);
  ASSERT_FALSE(solved_lay.lay.failure) << solved_lay.lay.failure->why;
  const auto make_start = [&](std::optional<bool> mean_drift) {
    Model model = solved_lay.model;
    model.description.statics.mean_drift = mean_drift;
    const Simulation simulation(model, *solved_lay.lay.solution, solved_lay.tension(), dynamic_options(model));
    EXPECT_FALSE(simulation.failure());
    return simulation.present().state->bodies.at(0);
  };
  const HullState drifted = make_start(std::nullopt), undrifted = make_start(false);
  EXPECT_LT(drifted.acc.head<3>().norm(), 1e-6 * kGravity);
  EXPECT_LT(drifted.acc.tail<3>().norm(), 1e-7);
  // 217.8 kN from the beam shift the barge on lines that balance the pipe by 1.184 m; these few components have less.
  const Sea sea = make_sea(d.environment.waves, d.environment.water_depth, d.environment.waves.front().seed);
  const CoupledHullDescription& hull = *d.vessel.coupled;
  const double drift = mean_drift(make_hull_waves(*hull.data, sea, hull.wave_drift, d.vessel.draught, 0.0), 0.0)(1);
  const double expected = 1.184 * drift / 217.8e3;
  EXPECT_NEAR(drifted.h(1) - undrifted.h(1), expected, 0.03 * expected);
  EXPECT_LT(std::abs(undrifted.h(1)), 0.02);
}

TEST(mooring_lines, go_with_the_barge_through_waves_and_keep_account_of_their_energy) {
  const testing::SolvedLay solved_lay(moored());
  ASSERT_FALSE(solved_lay.lay.failure) << solved_lay.lay.failure->why;
  Simulation simulation(solved_lay.model, *solved_lay.lay.solution, solved_lay.tension(),
                        dynamic_options(solved_lay.model));
  ASSERT_FALSE(simulation.failure()) << simulation.failure()->what;
  simulation.advance(0.5);
  const DynamicCheckpoint checkpoint = simulation.checkpoint();
  simulation.advance(1.0);
  ASSERT_FALSE(simulation.failure());
  EXPECT_LT(std::abs(simulation.energy().drift()), 5e-3);  // of little that has passed so soon
  Simulation resumed(solved_lay.model, *solved_lay.lay.solution, solved_lay.tension(),
                     dynamic_options(solved_lay.model));
  resumed.restore(checkpoint);
  resumed.advance(1.0);
  EXPECT_EQ(simulation.present().state->bodies[0].h, resumed.present().state->bodies[0].h);
  for (std::size_t i = 0; i < 9; ++i) {
    EXPECT_EQ(simulation.present().state->lines[i].q, resumed.present().state->lines[i].q) << i;
  }
}

/// Winches that move, a line that parts and an anchor that drags before the checkpoint.
Description busy() {
  Description d = moored();
  MooringsDescription& moorings = *d.moorings;
  WinchDescription mover = moorings.winches.front();
  mover.name = "mover";
  mover.mode = WinchMode::speed;
  mover.acceleration_time = 0.5;
  mover.program = {{0.0, 1.0}};
  WinchDescription keeper = moorings.winches.front();
  keeper.name = "keeper";
  keeper.mode = WinchMode::tension;
  keeper.tension = 280e3;
  keeper.band = 5e3;
  moorings.winches.push_back(mover);
  moorings.winches.push_back(keeper);
  moorings.lines[0].winch = "mover";
  moorings.lines[1].winch = "keeper";
  moorings.lines[2].fails_at = 0.1;
  d.statics.mean_drift = false;
  return d;
}

TEST(mooring_lines, whose_winches_move_part_and_drag_and_a_resumed_run_is_the_same) {
  testing::SolvedLay solved_lay(busy());
  ASSERT_FALSE(solved_lay.lay.failure) << solved_lay.lay.failure->why;
  solved_lay.model.description.moorings->lines[3].anchor_holding = {
      0.95 * solved_lay.lay.moorings->rest.moorings[3].anchor_tension, true};  // it drags from the start
  ASSERT_FALSE(unsupported_in_dynamics(solved_lay.model));
  DynamicOptions options = dynamic_options(solved_lay.model);
  options.build_up = 0.2;
  options.output_step = 0.1;
  Simulation simulation(solved_lay.model, *solved_lay.lay.solution, solved_lay.tension(), options);
  ASSERT_FALSE(simulation.failure()) << simulation.failure()->what;
  simulation.advance(0.2);
  const DynamicCheckpoint checkpoint = simulation.checkpoint();
  simulation.advance(0.4);
  ASSERT_FALSE(simulation.failure()) << simulation.failure()->where;
  const SystemState& end = *simulation.present().state;
  const auto fairlead = [&](std::size_t line) { return end.attachments.at(3 + 2 * line); };
  const auto anchor = [&](std::size_t line) { return end.attachments.at(2 + 2 * line); };
  EXPECT_GT(fairlead(0).payout.moved, 0.01);
  EXPECT_GT(std::abs(fairlead(1).payout.moved), 1e-4);
  EXPECT_TRUE(fairlead(2).parted);
  EXPECT_LT(fairlead_tension(simulation, 3), 1.0);
  EXPECT_GT(anchor(3).payout.rendered_length, 0.001);
  Simulation resumed(solved_lay.model, *solved_lay.lay.solution, solved_lay.tension(), options);
  resumed.restore(checkpoint);
  resumed.advance(0.4);
  EXPECT_EQ(end.bodies[0].h, resumed.present().state->bodies[0].h);
  for (std::size_t i = 0; i < 9; ++i) {
    EXPECT_EQ(end.lines[i].q, resumed.present().state->lines[i].q) << i;
  }
}

/// In still water, as prescribed.
Description surging() {
  Description d = moored();
  d.environment.waves.front().type = WaveType::none;
  d.vessel.motion = VesselMotion::harmonic;
  d.vessel.coupled.reset();
  d.vessel.harmonic["surge"] = {1.0, 8.0, 0.0};
  return d;
}

/// The vessel surges as prescribed; its lines do what a line by itself does whose end moves so.
TEST(mooring_lines, on_a_vessel_whose_motion_is_prescribed_swing_as_lines_by_themselves) {
  Description d = surging();
  d.dynamics->build_up = 4.0;
  d.dynamics->duration = 2.0;
  for (MooringLineDescription& line : d.moorings->lines) {
    for (LineSegmentDescription& segment : line.segments) segment.type.friction = 0.0;
  }
  const testing::SolvedLay solved_lay(d);
  ASSERT_FALSE(solved_lay.lay.failure) << solved_lay.lay.failure->why;
  ASSERT_FALSE(unsupported_in_dynamics(solved_lay.model));
  DynamicOptions options = dynamic_options(solved_lay.model);
  options.error_tolerance = 2e-4;  // each takes steps of its own
  Simulation simulation(solved_lay.model, *solved_lay.lay.solution, solved_lay.tension(), options);
  ASSERT_FALSE(simulation.failure()) << simulation.failure()->what;
  const MooredLine& moored = solved_lay.lay.solution->moorings->lines[0];
  EXPECT_NEAR(fairlead_tension(simulation, 1), solved_lay.lay.moorings->rest.moorings[0].fairlead_tension, 400.0);

  Description alone = d;
  alone.has_pipe = false;
  FreeLineDescription line;
  line.first.at = moored.anchor_W;
  line.second.kind = LineEndKind::body;
  line.second.at = moored.fairlead_V;
  line.segments = d.moorings->lines[0].segments;
  line.segments[0].length = moored.line.first_segment();
  alone.lines = {line};
  alone.moorings.reset();
  const LineHistory history = testing::run_lines(alone, options).front();
  for (std::size_t row = 0; row < history.time.size(); ++row) {
    simulation.advance(history.time[row]);
    ASSERT_FALSE(simulation.failure());
    EXPECT_NEAR(fairlead_tension(simulation, 1), history.last[row], 1e-3 * history.last[row]) << history.time[row];
  }
  EXPECT_GT(history.max_last_tension, 1.05 * history.min_last_tension);
}

/// At the fairleads every half second, of wires that stick and slide on the bed.
std::vector<double> tensions_by(const testing::SolvedLay& solved_lay, double step_error) {
  DynamicOptions options = dynamic_options(solved_lay.model);
  options.error_tolerance = step_error;
  Simulation simulation(solved_lay.model, *solved_lay.lay.solution, solved_lay.tension(), options);
  std::vector<double> tensions;
  for (double time = 0.5; time <= 8.0; time += 0.5) {
    simulation.advance(time);
    EXPECT_FALSE(simulation.failure());
    for (std::size_t line = 1; line <= 8; ++line) tensions.push_back(fairlead_tension(simulation, line));
  }
  return tensions;
}

TEST(mooring_lines, have_tensions_that_do_not_depend_on_the_step) {
  Description d = surging();
  d.vessel.harmonic["sway"] = {1.5, 10.0, 1.0};
  d.dynamics->build_up = 8.0;
  d.dynamics->duration = 8.0;
  const testing::SolvedLay solved_lay(d);
  ASSERT_FALSE(solved_lay.lay.failure) << solved_lay.lay.failure->why;
  const std::vector<double> usual = tensions_by(solved_lay, dynamic_options(solved_lay.model).error_tolerance),
                            fine = tensions_by(solved_lay, 2e-5);
  // Friction of the bed is of first order in the step: see docs/theory/integrator.md.
  for (std::size_t line = 0; line < 8; ++line) {
    double max_value = 0.0, max_fine = 0.0, min_fine = 1e300;
    for (std::size_t i = line; i < fine.size(); i += 8) {
      EXPECT_NEAR(usual[i], fine[i], 0.01 * 300e3) << line << " " << i / 8;  // of the tension at rest
      max_value = std::max(max_value, usual[i]);
      max_fine = std::max(max_fine, fine[i]);
      min_fine = std::min(min_fine, fine[i]);
    }
    EXPECT_NEAR(max_value, max_fine, 0.005 * max_fine) << line;
    EXPECT_GT(max_fine, 1.4 * min_fine) << line;
  }
}

TEST(mooring_lines, are_rejected_in_time_where_more_is_asked_of_them_than_they_do) {
  const auto rejected = [](const std::function<void(Description&)>& change) {
    Description d = moored();
    change(d);
    return unsupported_in_dynamics(build_model(d)).has_value();
  };
  EXPECT_FALSE(rejected([](Description&) {}));
  EXPECT_FALSE(rejected([](Description& d) { d.moorings->model = MooringModel::quasi_static; }));
  EXPECT_FALSE(rejected([](Description& d) { d.operation.type = OperationType::pull_ahead; }));
  EXPECT_TRUE(rejected([](Description& d) { d.operation.type = OperationType::anchor_move; }));
  EXPECT_TRUE(rejected([](Description& d) {
    d.moorings->model = MooringModel::quasi_static;
    d.moorings->lines.front().fails_at = 100.0;
  }));
  EXPECT_TRUE(rejected([](Description& d) {
    d.moorings->model = MooringModel::quasi_static;
    d.moorings->winches.front().mode = WinchMode::length;
    d.moorings->winches.front().program = {{60.0, -8.0}};
  }));
  EXPECT_FALSE(rejected([](Description& d) { d.moorings->winches.front().mode = WinchMode::tension; }));
  EXPECT_FALSE(rejected([](Description& d) { d.moorings->lines.front().fails_at = 100.0; }));
  EXPECT_FALSE(rejected([](Description& d) { d.vessel.motion = VesselMotion::fixed; }));
}

}  // namespace
}  // namespace overbend
