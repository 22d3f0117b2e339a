/// BGL-1 pulled ahead in time, on lines of elements and on quasi-static ones.
#include "dynamics/setup/winch_programs.h"

#include <gtest/gtest.h>

#include "dynamics/machines/mooring_tension.h"
#include "dynamics/run/simulation.h"
#include "dynamics/setup/unsupported_in_dynamics.h"
#include "support/moored_lay.h"

namespace overbend {
namespace {

/// A short way at once, in calm water, on a coarse mesh.
Description pulled(MooringModel model) {
  Description d = testing::coarse_example("bgl1-pull-ahead", 8.0, 1.0);
  d.moorings->model = model;
  d.environment.waves.front().type = WaveType::none;
  d.environment.current.clear();
  d.operation.distance = 0.6;
  d.operation.acceleration_time = 2.0;
  d.operation.start = 0.5;
  return d;
}

TEST(moored_pull_ahead, has_winches_that_go_through_the_lengths_of_the_plan) {
  const testing::SolvedLay solved_lay(pulled(MooringModel::elements));
  ASSERT_FALSE(solved_lay.lay.failure) << solved_lay.lay.failure->why;
  ASSERT_FALSE(unsupported_in_dynamics(solved_lay.model));
  Simulation simulation(solved_lay.model, *solved_lay.lay.solution, solved_lay.tension(),
                        dynamic_options(solved_lay.model));
  ASSERT_FALSE(simulation.failure()) << simulation.failure()->what;
  const std::vector<LengthTable> programs = winch_programs(*solved_lay.lay.solution);
  ASSERT_EQ(programs.size(), 8U);
  while (simulation.step()) {
  }
  ASSERT_FALSE(simulation.failure()) << simulation.failure()->why;
  const Instant instant = simulation.present();
  std::size_t mooring = 0;
  for (std::size_t i = 0; i < simulation.system().attachments.size(); ++i) {
    const Attachment& held = simulation.system().attachments[i];
    if (held.line == 0 || held.end != LineEnd::last) continue;
    const LengthTable& program = programs[mooring++];
    const double change = program.lengths.back() - program.lengths.front();
    EXPECT_GT(std::abs(change), 0.2);
    EXPECT_NEAR(instant.state->attachments[i].payout.moved, change, 1e-9) << mooring;
  }
  EXPECT_EQ(mooring, 8U);
  // Lines ahead are shorter, lines astern longer, and the hull has hardly begun its swing of 67 s.
  EXPECT_GT(instant.state->bodies[0].v(0), 0.0);
  EXPECT_LT(std::abs(simulation.energy().drift()), 1e-2);  // of little that has passed so soon
}

/// On lines that follow at once the hull, whose surge takes 67 s, has gone (2 pi/67 s)^2 times the way of the plan,
/// integrated twice over 7.5 s: some 0.06 m. Lines of elements resist the water on their way up and pull more.
TEST(moored_pull_ahead, begins_sooner_on_lines_that_the_water_resists) {
  const auto direction = [](MooringModel model) {
    const testing::SolvedLay solved_lay(pulled(model));
    Simulation simulation(solved_lay.model, *solved_lay.lay.solution, solved_lay.tension(),
                          dynamic_options(solved_lay.model));
    EXPECT_FALSE(simulation.failure());
    const double first = simulation.present().state->bodies.at(0).h(0);
    while (simulation.step()) {
    }
    EXPECT_FALSE(simulation.failure());
    return simulation.present().state->bodies.at(0).h(0) - first;
  };
  const double quasi_static = direction(MooringModel::quasi_static);
  EXPECT_NEAR(quasi_static, 0.06, 0.01);
  EXPECT_GT(direction(MooringModel::elements), 1.2 * quasi_static);
}

}  // namespace
}  // namespace overbend
