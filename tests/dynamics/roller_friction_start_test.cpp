// A run that starts from statics with friction on the rollers (analysis.static.roller_friction).
#include <gtest/gtest.h>

#include "dynamics/run/simulation.h"
#include "support/bgl1_in_time.h"
#include "support/moored_lay.h"

namespace overbend {
namespace {

Description rubbing(Description d, RollerFriction friction) {
  d.environment.waves.front() = {};
  for (RollerKindDescription& kind : d.rollers) kind.friction_axial = 0.1;
  d.tensioner.mode = TensionerMode::locked;
  d.statics.roller_friction = friction;
  return d;
}

// In calm water nothing moves: the friction of statics is there at t = 0 and stays. Dropped, it leaves 7 kN more or
// less at the tensioner.
TEST(roller_friction_start, a_run_in_calm_water_stays_at_the_equilibrium_of_statics) {
  for (const RollerFriction friction : {RollerFriction::lay, RollerFriction::haul}) {
    Description d = rubbing(testing::workable(), friction);
    d.vessel.motion = VesselMotion::fixed;
    const testing::TimedLay lay(d);
    Simulation simulation(lay.model, lay.start, lay.statics.top_tension, dynamic_options(lay.model));
    EXPECT_NEAR(simulation.tension(), lay.statics.top_tension, 1.0);
    ASSERT_TRUE(simulation.advance(-2.0));
    EXPECT_NEAR(simulation.tension(), lay.statics.top_tension, 1.0);
  }
}

// The hull reaches equilibrium with the pipe before the run starts: with its friction too.
TEST(roller_friction_start, a_floating_hull_comes_to_rest_with_the_friction_of_statics) {
  const Description d = rubbing(testing::coarse_example("bgl1-moored", 1.0, 2.0), RollerFriction::lay);
  const testing::SolvedLay lay(d);
  ASSERT_TRUE(lay.lay.solution);
  Simulation simulation(lay.model, *lay.lay.solution, lay.tension(), dynamic_options(lay.model));
  ASSERT_FALSE(simulation.failure()) << simulation.failure()->why;
  EXPECT_NEAR(simulation.tension(), lay.tension(), 1e-3 * lay.tension());
}

}  // namespace
}  // namespace overbend
