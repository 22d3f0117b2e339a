/// BGL-1 on its eight lines in time, without a pipe.
#include <gtest/gtest.h>

#include <cmath>

#include "dynamics/machines/mooring_tension.h"
#include "dynamics/run/simulation.h"
#include "recording/vessel_recorder.h"
#include "support/allocation_count.h"
#include "support/moored_lay.h"

namespace overbend {
namespace {

using testing::coarse_example;
using testing::SolvedHull;

/// In calm water, as the natural periods of the reference are.
Description calm(MooringModel lines) {
  Description d = coarse_example("moored-barge", 200.0, 0.0);
  d.environment.waves.front().type = WaveType::none;
  d.environment.current.clear();
  d.moorings->model = lines;
  return d;
}

/// Time between the first two passages of its mean place in one direction, after it was released [s].
double period(const SolvedHull& moored, Eigen::Index freedom, double release) {
  DynamicOptions options = dynamic_options(moored.model);
  options.fixed_step = 0.25;
  options.release(freedom) = release;
  Simulation simulation(moored.model, moored.start(), 0.0, options);
  EXPECT_FALSE(simulation.failure());
  // The hull is drawn where it lies.
  const auto off = [&] {
    const HullState& hull = simulation.present().state->bodies.front();
    return hull.h(freedom) - simulation.system().bodies.front().free->origin(freedom);
  };
  double before = off(), first = 0.0;
  int passages = 0;
  while (simulation.step()) {
    const double after = off();
    if (before * after <= 0.0) {
      const double passed = simulation.time() - 0.25 * after / (after - before);
      if (++passages == 1) first = passed;
      if (passages == 3) return passed - first;
    }
    before = after;
  }
  return 0.0;
}

/// Eigenvalues of hull, fitted memory and the lines' stiffness, by an independent prototype; heading east, surge is
/// eastwards.
TEST(moored_hull, swings_with_the_periods_of_hull_water_and_lines) {
  const SolvedHull moored(calm(MooringModel::quasi_static));
  EXPECT_NEAR(period(moored, 0, 0.05), 66.96, 0.005 * 66.96);
  EXPECT_NEAR(period(moored, 1, 0.05), 77.15, 0.005 * 77.15);
  EXPECT_NEAR(period(moored, 5, 0.001), 44.64, 0.005 * 44.64);
}

/// A tenth of critical: one swing after the other is smaller by exp(-2 pi 0.1/sqrt(1 - 0.01)), 0.532.
TEST(moored_hull, is_damped_by_the_share_of_critical_that_is_asked_for) {
  Description d = calm(MooringModel::quasi_static);
  d.vessel.coupled->damping.push_back({"surge", 0.1, std::nullopt, std::nullopt});
  const SolvedHull moored(d);
  DynamicOptions options = dynamic_options(moored.model);
  options.fixed_step = 0.25;
  options.release(0) = 0.1;
  Simulation simulation(moored.model, moored.start(), 0.0, options);
  ASSERT_FALSE(simulation.failure());
  const double rest = simulation.system().bodies.front().free->origin(0);
  double max_value = 0.0;  // of the second swing to the same side, around 67 s
  while (simulation.step()) {
    const double off = simulation.present().state->bodies.front().h(0) - rest;
    if (simulation.time() > 45.0) max_value = std::max(max_value, off);
  }
  EXPECT_NEAR(max_value, 0.1 * 0.532, 0.1 * 0.02);
}

TEST(moored_hull, stays_where_statics_put_it_in_calm_water) {
  Description d = calm(MooringModel::elements);
  d.dynamics->duration = 20.0;
  const SolvedHull moored(d);
  Simulation simulation(moored.model, moored.start(), 0.0, dynamic_options(moored.model));
  ASSERT_FALSE(simulation.failure());
  const Vec6 first = simulation.present().state->bodies.front().h;
  EXPECT_TRUE(simulation.advance(simulation.end()));
  EXPECT_LT((simulation.present().state->bodies.front().h - first).norm(), 1e-5);
  // Catenaries of statics, elements here.
  for (std::size_t i = 0; i < 8; ++i) {
    const double tension = moored.rest.moorings->rest.moorings[i].fairlead_tension;
    const double current =
        mooring_tension(*simulation.present().assembly, *simulation.present().state, i, LineEnd::last);
    EXPECT_NEAR(current, tension, 2e-3 * tension) << i;
  }
}

/// A hull whose crew does not ballast for the pull of its lines sinks by it, once, and in time as in statics.
TEST(moored_hull, sinks_under_its_lines_as_in_statics_where_it_is_not_ballasted) {
  Description d = calm(MooringModel::quasi_static);
  d.dynamics->duration = 2.0;
  d.vessel.coupled->ballast = Ballast::as_given;
  d.vessel.loads = {{"crane", Vec3(0.0, 10.0, 0.0), Vec3(0.0, 0.0, -2e6), Vec3::Zero()}};
  const SolvedHull moored(d);
  const VesselResult& statics = moored.rest.moorings->rest.vessel;
  EXPECT_LT(statics.heave, -0.05);
  EXPECT_LT(statics.roll, -0.005);
  Simulation simulation(moored.model, moored.start(), 0.0, dynamic_options(moored.model));
  ASSERT_FALSE(simulation.failure());
  EXPECT_TRUE(simulation.advance(2.0));
  const auto shift =
      shift_between(moored.model.nominal_pose, simulation.present().assembly->surroundings().bodies[0].pose);
  EXPECT_NEAR(shift[2], statics.heave, 1e-3 * std::abs(statics.heave));
  EXPECT_NEAR(shift[3], statics.roll, 1e-3 * std::abs(statics.roll));
  EXPECT_NEAR(shift[1], statics.sway, 1e-3 * std::abs(statics.sway) + 1e-5);
}

/// With prescribed motion of the vessel, lines are independent of a pipe: there they move as in the system of a lay.
TEST(moored_hull, has_lines_that_move_as_those_next_to_a_pipe) {
  Description d = coarse_example("bgl1-moored", 6.0, 2.0);
  d.vessel.motion = VesselMotion::harmonic;
  d.vessel.coupled.reset();
  d.vessel.harmonic["heave"] = {0.8, 9.0, 0.0};
  const testing::SolvedLay lay(d);
  ASSERT_FALSE(lay.lay.failure) << lay.lay.failure->why;
  DynamicOptions options = dynamic_options(lay.model);
  options.fixed_step = 0.02;
  Simulation neighbour(lay.model, *lay.lay.solution, lay.tension(), options);
  d.environment.seabed.stiffness =
      neighbour.system().lines[1].environment.bed_stick;  // of the soil; under the pipe it is more
  d.has_pipe = false;
  const SolvedHull moored(d);
  Simulation alone(moored.model, moored.start(), 0.0, options);
  ASSERT_FALSE(alone.failure() || neighbour.failure());
  double min_value = 1e300, max_magnitude = 0.0;
  while (!neighbour.finished()) {  // rows are met by both; the pipe on its rollers may need shorter steps between
    const double row = neighbour.next_row();
    ASSERT_TRUE(alone.advance(row) && neighbour.advance(row));
    ASSERT_NEAR(alone.time(), neighbour.time(), 1e-9);
    for (std::size_t i = 0; i < 8; ++i) {
      const double single = mooring_tension(*alone.present().assembly, *alone.present().state, i, LineEnd::last);
      const double second =
          mooring_tension(*neighbour.present().assembly, *neighbour.present().state, i, LineEnd::last);
      EXPECT_NEAR(single, second, 5e-4 * second) << i << " at " << neighbour.time();
      min_value = std::min(min_value, single);
      max_magnitude = std::max(max_magnitude, single);
    }
  }
  EXPECT_GT(max_magnitude, 1.1 * min_value);  // they do move
}

TEST(moored_hull, in_a_sea_keeps_its_energy_and_allocates_nothing_in_a_step) {
  const SolvedHull moored(coarse_example("moored-barge", 30.0, 20.0));
  Simulation simulation(moored.model, moored.start(), 0.0, dynamic_options(moored.model));
  ASSERT_FALSE(simulation.failure());
  Simulation& run = simulation;
  run.advance(-10.0);
  const long before = testing::allocation_count();
  run.advance(-5.0);
  EXPECT_EQ(testing::allocation_count(), before);
  EXPECT_TRUE(run.advance(run.end()));
  EXPECT_LT(std::abs(run.energy().drift()), 1e-3);
}

TEST(moored_hull, goes_on_after_a_line_has_parted) {
  Description d = coarse_example("moored-barge", 30.0, 5.0);
  d.environment.waves.front().type = WaveType::none;
  d.moorings->lines[0].fails_at = 2.0;
  const SolvedHull moored(d);
  Simulation simulation(moored.model, moored.start(), 0.0, dynamic_options(moored.model));
  ASSERT_FALSE(simulation.failure());
  Simulation& run = simulation;
  EXPECT_TRUE(run.advance(1.0));
  const double before = run.present().state->bodies.front().h(0);
  EXPECT_TRUE(run.advance(run.end())) << run.failure()->what;
  EXPECT_LT(mooring_tension(*run.present().assembly, *run.present().state, 0, LineEnd::last), 1.0);
  // Without its port bow line the barge, heading east, is pulled astern by the others: some 285 kN cos 25 deg on 21,000
  // t.
  EXPECT_LT(run.present().state->bodies.front().h(0), before - 0.3);
}

/// The winches take it along the plan of statics; what is left swings with the surge period of 67 s.
TEST(moored_hull, is_pulled_ahead_by_its_winches) {
  Description d = calm(MooringModel::quasi_static);
  d.dynamics->duration = 260.0;
  d.operation.type = OperationType::pull_ahead;
  d.operation.distance = 3.0;
  d.operation.speed = 0.15;
  d.operation.acceleration_time = 10.0;
  d.operation.start = 5.0;
  const SolvedHull moored(d);
  ASSERT_TRUE(moored.start().winches);
  Simulation simulation(moored.model, moored.start(), 0.0, dynamic_options(moored.model));
  ASSERT_FALSE(simulation.failure());
  Simulation& run = simulation;
  const double from = run.present().state->bodies.front().h(0);
  double sum = 0.0, time = 0.0;
  while (run.step()) {
    if (run.time() < run.end() - 2.0 * 66.96) continue;
    sum += (run.present().state->bodies.front().h(0) - from) * run.present().state->last_step;
    time += run.present().state->last_step;
  }
  ASSERT_FALSE(run.failure());
  EXPECT_NEAR(sum / time, 3.0, 0.03);
}

}  // namespace
}  // namespace overbend
