/// BGL-1 and its pipe pulled ahead on eight lines, place by place.
#include "statics/moored/pull_ahead.h"

#include <gtest/gtest.h>

#include "base/constants.h"
#include "modelfile/reading/yaml_reader.h"
#include "statics/moored/moored_lay.h"
#include "statics/moored/pipe_load.h"

namespace overbend {
namespace {

Description pulled(double distance) {
  Description d = read_model(OVERBEND_SOURCE_DIR "/examples/bgl1-moored.yaml").description.value();
  d.environment.current.clear();
  d.mesh.overbend_element = 1.0;
  d.mesh.touchdown_element = 3.0;
  d.mesh.max_element_length = 8.0;
  d.operation.type = OperationType::pull_ahead;
  d.operation.distance = distance;
  return d;
}

TEST(pull_ahead, has_the_pipe_at_each_of_its_places) {
  Model model = build_model(pulled(12.0));
  const ModelEquilibrium lay = solve_lay(model);
  ASSERT_FALSE(lay.failure) << lay.failure->why;
  const std::vector<MoveStep>& steps = lay.moorings->steps;
  ASSERT_EQ(steps.size(), 25U);
  EXPECT_NEAR(model.mean_pose.p_WV.x(), 0.0, 1e-6);  // dynamics begin where the way begins
  for (std::size_t i = 0; i < steps.size(); ++i) {
    ASSERT_TRUE(steps[i].pipe);
    EXPECT_NEAR(steps[i].advance, 0.5 * static_cast<double>(i), 1e-12);
    EXPECT_NEAR(steps[i].vessel.surge, steps[i].advance, 1e-6);
    // On a level bed the lay goes with the barge.
    EXPECT_NEAR(steps[i].pipe->top_tension, 250e3, 10.0);
    EXPECT_NEAR(steps[i].pipe->bottom_tension, steps[0].pipe->bottom_tension, 20.0);
    EXPECT_NEAR(steps[i].pipe->overbend_bending_stress, steps[0].pipe->overbend_bending_stress, 5e5);
    EXPECT_NEAR(steps[i].pipe->lay_back, steps[0].pipe->lay_back, 0.1);
  }
  // The closed form for 64 mm wire at 300 kN with the pull of this pipe, two digits given; weight and sea water of the
  // model differ by a permille from those it was made with.
  const double change[] = {-10.90, -5.02, 5.17, 10.96};
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_NEAR(steps.back().lengths[i] - steps.front().lengths[i], change[i], 0.02) << i;
    EXPECT_LT(std::abs(steps.back().tensions[i] - steps.front().tensions[i]), 3.3e3);
  }
}

// Turned by a load on its bow, the barge still goes along the route: 0.3 deg off would be 0.06 m in a joint of 12 m.
TEST(pull_ahead, of_a_turned_barge_goes_along_the_lay_route) {
  Description d = pulled(12.0);
  d.moorings->find = FindMooring::pose;
  VesselLoadDescription& push = d.vessel.loads.emplace_back();
  push.name = "push";
  push.at = Vec3(50.0, 0.0, 0.0);
  push.force = Vec3(0.0, 60e3, 0.0);
  Model model = build_model(d);
  const ModelEquilibrium lay = solve_lay(model);
  ASSERT_FALSE(lay.failure) << lay.failure->why;
  const std::vector<MoveStep>& steps = lay.moorings->steps;
  ASSERT_GT(std::abs(steps.front().vessel.yaw), 0.2 * kDegree);
  EXPECT_NEAR(steps.back().vessel.surge - steps.front().vessel.surge, 12.0, 1e-6);
  EXPECT_NEAR(steps.back().vessel.sway, steps.front().vessel.sway, 1e-6);
}

TEST(pull_ahead, and_back_ends_in_the_state_it_began_with) {
  const Description d = pulled(12.0);
  Model model = build_model(d);
  const StaticSolution pipe = solve_statics(model).solution.value();
  MooredHull moored = std::get<MooredHull>(moored_hull(model));
  const Vec6 load = pipe_load(model, pipe, moored.hull);
  moored.hull.steady += load;
  find_initial_equilibrium(d, moored);
  PullAheadPath hull(model, moored, pipe_on_hull(model, pipe, moored.hull, load));
  ASSERT_FALSE(hull.advance_to(0.0));
  const MoveStep first = hull.step();
  for (const double distance : {4.0, 12.0, 7.0, 0.0}) {
    ASSERT_FALSE(hull.advance_to(distance)) << distance;
  }
  const MoveStep& last = hull.step();
  EXPECT_NEAR(last.vessel.surge, first.vessel.surge, 1e-8);
  EXPECT_NEAR(last.vessel.heave, first.vessel.heave, 1e-8);
  EXPECT_NEAR(last.vessel.pitch, first.vessel.pitch, 1e-8);
  EXPECT_NEAR(last.vessel.yaw, first.vessel.yaw, 1e-8);
  for (std::size_t i = 0; i < first.lengths.size(); ++i) {
    EXPECT_NEAR(last.lengths[i], first.lengths[i], 1e-8 * first.lengths[i]);
    EXPECT_NEAR(last.tensions[i], first.tensions[i], 1e-6 * first.tensions[i]);  // 1e-8 of the pipe's weight
  }
}

}  // namespace
}  // namespace overbend
