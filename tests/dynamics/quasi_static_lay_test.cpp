/// BGL-1 afloat under its pipe on eight quasi-static mooring lines.
#include <gtest/gtest.h>

#include "dynamics/machines/mooring_tension.h"
#include "dynamics/run/simulation.h"
#include "dynamics/setup/unsupported_in_dynamics.h"
#include "support/moored_lay.h"

namespace overbend {
namespace {

Description quasi_static() {
  Description d = testing::coarse_example("bgl1-moored", 1.0, 2.0);
  d.moorings->model = MooringModel::quasi_static;
  return d;
}

double compute_end_tension(const Simulation& simulation, std::size_t mooring, LineEnd end) {
  const Instant instant = simulation.present();
  return mooring_tension(*instant.assembly, *instant.state, mooring, end);
}

TEST(quasi_static_lay, begins_with_the_tensions_of_statics_and_stays_there_in_calm_water) {
  Description d = quasi_static();
  d.environment.waves.front().type = WaveType::none;
  d.environment.current.clear();
  const testing::SolvedLay solved_lay(d);
  ASSERT_FALSE(solved_lay.lay.failure) << solved_lay.lay.failure->why;
  ASSERT_FALSE(unsupported_in_dynamics(solved_lay.model));
  Simulation simulation(solved_lay.model, *solved_lay.lay.solution, solved_lay.tension(),
                        dynamic_options(solved_lay.model));
  ASSERT_FALSE(simulation.failure()) << simulation.failure()->what;
  ASSERT_EQ(simulation.moorings().size(), 8U);
  EXPECT_EQ(simulation.present().state->lines.size(), 1U);  // the pipe
  const HullState first = simulation.present().state->bodies.at(0);
  EXPECT_LT(first.acc.head<3>().norm(), 1e-6 * kGravity);
  for (std::size_t i = 0; i < 8; ++i) {
    const MooringLineResult& line = solved_lay.lay.moorings->rest.moorings[i];
    // The hull lies where statics put it but for the mesh of the pipe and its friction on the bed, to some millimetres.
    EXPECT_NEAR(compute_end_tension(simulation, i, LineEnd::last), line.fairlead_tension, 1e-3 * line.fairlead_tension)
        << i;
    EXPECT_NEAR(compute_end_tension(simulation, i, LineEnd::first), line.anchor_tension, 1e-3 * line.fairlead_tension)
        << i;
  }
  while (simulation.step()) {
  }
  ASSERT_FALSE(simulation.failure());
  EXPECT_LT((simulation.present().state->bodies[0].h - first.h).norm(), 1e-5);
}

TEST(quasi_static_lay, goes_through_waves_and_resumes_bit_for_bit) {
  const testing::SolvedLay solved_lay(quasi_static());
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
  EXPECT_EQ(compute_end_tension(simulation, 0, LineEnd::last), compute_end_tension(resumed, 0, LineEnd::last));
}

TEST(quasi_static_lay, is_rejected_where_its_lines_should_do_more_than_pull) {
  const auto rejected = [](const std::function<void(Description&)>& change) {
    Description d = quasi_static();
    change(d);
    return unsupported_in_dynamics(build_model(d)).has_value();
  };
  EXPECT_FALSE(rejected([](Description&) {}));
  EXPECT_TRUE(rejected([](Description& d) { d.moorings->winches.front().mode = WinchMode::tension; }));
  EXPECT_TRUE(rejected([](Description& d) { d.moorings->lines.front().fails_at = 100.0; }));
  EXPECT_TRUE(rejected([](Description& d) { d.moorings->lines.front().anchor_holding.slides = true; }));
  EXPECT_TRUE(rejected([](Description& d) { d.vessel.motion = VesselMotion::fixed; }));
}

}  // namespace
}  // namespace overbend
