/// The pipe of BGL-1, its barge and eight mooring lines at rest.
#include "statics/moored/moored_lay.h"

#include <gtest/gtest.h>

#include "modelfile/reading/yaml_reader.h"
#include "statics/moored/vessel_load.h"
#include "statics/recovery/recovery.h"
#include "statics/recovery/side_rollers.h"

namespace overbend {
namespace {

Description moored() {
  return read_model(OVERBEND_SOURCE_DIR "/examples/bgl1-moored.yaml").description.value();
}

Description held() {
  Description d = moored();
  d.moorings.reset();
  d.vessel.coupled.reset();
  d.vessel.motion = VesselMotion::fixed;
  return d;
}

TEST(moored_lay, a_barge_held_as_drawn_by_its_lengths_bends_the_pipe_as_a_fixed_one_does) {
  Model moored_model = build_model(moored()), held_model = build_model(held());
  const ModelEquilibrium moored_lay = solve_lay(moored_model);
  const ModelEquilibrium held_lay = solve_lay(held_model);
  ASSERT_FALSE(moored_lay.failure) << moored_lay.failure->why;
  const StaticResults a = recover_statics(moored_model, *moored_lay.solution);
  const StaticResults b = recover_statics(held_model, *held_lay.solution);
  EXPECT_NEAR(a.overbend->bending_stress.value, b.overbend->bending_stress.value, 1.0);
  EXPECT_NEAR(moored_lay.moorings->rest.vessel.surge, 0.0, 1e-6);
  EXPECT_NEAR(moored_lay.moorings->rest.vessel.heave, 0.0, 1e-6);
}

TEST(moored_lay, the_lines_hold_what_the_pipe_pulls) {
  Model model = build_model(moored());
  const ModelEquilibrium lay = solve_lay(model);
  ASSERT_FALSE(lay.failure) << lay.failure->why;
  StaticSystem system(model, model.mean_pose, lay.solution->mesh);
  const Vec6 load = load_on_vessel(system, lay.solution->state);
  // Along the barge, which heads east, the lines' pull ahead is the pipe's pull astern.
  EXPECT_NEAR(lay.moorings->rest.mooring_force.at(0), -load(0), 1.0);
  EXPECT_NEAR(lay.moorings->rest.mooring_force.at(5), -load(5), 100.0);
}

/// Everything that acts on the pipe but vessel and far end is its weight, the water and the bed.
TEST(moored_lay, the_load_on_the_vessel_balances_the_pipe) {
  Model model = build_model(held());
  const ModelEquilibrium lay = solve_lay(model);
  const StaticResults r = recover_statics(model, *lay.solution);
  StaticSystem system(model, model.mean_pose, lay.solution->mesh);
  const Vec3 load = load_on_vessel(system, lay.solution->state).head<3>();
  const Vec3 rest = r.sum_weight + r.sum_buoyancy + r.sum_current + r.sum_seabed + r.anchor_reaction;
  EXPECT_LT((load - rest).norm(), 1e-6 * r.total_weight);
}

/// A wire from the stern to the pipe behind the stinger.
Description with_wire(Description d) {
  FreeLineDescription& wire = d.lines.emplace_back();
  wire.name = "wire";
  wire.first.kind = LineEndKind::body;
  wire.first.body = "vessel";
  wire.first.at = Vec3(-150.0, 0.0, 10.0);
  wire.second.kind = LineEndKind::line;
  wire.second.line = "pipe";
  wire.second.arc_length = 150.0;
  LineSegmentDescription& segment = wire.segments.emplace_back();
  segment.length = 20.0;
  segment.type.axial_stiffness = 1e6;
  return d;
}

TEST(moored_lay, a_wire_from_the_vessel_is_in_the_load_on_it) {
  Model model = build_model(with_wire(held()));
  const ModelEquilibrium lay = solve_lay(model);
  ASSERT_FALSE(lay.failure) << lay.failure->why;
  const StaticResults r = recover_statics(model, *lay.solution);
  ASSERT_GT(r.wires.at(0).tension_upper, 1e3);
  StaticSystem system(model, model.mean_pose, lay.solution->mesh);
  const Vec3 load = load_on_vessel(system, lay.solution->state).head<3>();
  const Vec3 rest = r.sum_weight + r.sum_buoyancy + r.sum_current + r.sum_seabed + r.anchor_reaction;
  EXPECT_LT((load - rest).norm(), 1e-6 * r.total_weight);
}

TEST(moored_lay, the_lines_hold_what_a_wire_to_the_pipe_pulls) {
  Model model = build_model(with_wire(moored()));
  const ModelEquilibrium lay = solve_lay(model);
  ASSERT_FALSE(lay.failure) << lay.failure->why;
  StaticSystem system(model, model.mean_pose, lay.solution->mesh);
  const Vec6 load = load_on_vessel(system, lay.solution->state);
  EXPECT_NEAR(lay.moorings->rest.mooring_force.at(0), -load(0), 1.0);
}

TEST(moored_lay, a_barge_with_given_lengths_gives_way_to_the_pipe) {
  Description d = moored();
  d.environment.current.clear();
  d.moorings->find = FindMooring::pose;
  Model model = build_model(d);
  const ModelEquilibrium lay = solve_lay(model);
  ASSERT_FALSE(lay.failure) << lay.failure->why;
  const VesselResult& vessel = lay.moorings->rest.vessel;
  // Some 205 kN on 185 kN/m.
  EXPECT_GT(vessel.surge, -1.3);
  EXPECT_LT(vessel.surge, -0.9);
  EXPECT_NEAR(model.mean_pose.p_WV.x(), vessel.surge, 1e-9);
  // The pipe is laid with the same tension from there.
  const StaticResults r = recover_statics(model, *lay.solution);
  EXPECT_NEAR(r.top_tension, 250e3, 10.0);
  EXPECT_LT(r.global_residual, 1e-6);
}

TEST(moored_lay, starts_from_the_solution_of_a_neighbour) {
  Description d = moored();
  d.environment.current.clear();
  d.moorings->find = FindMooring::pose;
  Model model = build_model(d);
  const ModelEquilibrium first = solve_lay(model);
  const double surge = first.moorings->rest.vessel.surge;
  const ModelEquilibrium again = solve_lay(model, &*first.solution);
  EXPECT_NEAR(again.moorings->rest.vessel.surge, surge, 1e-6);
}

TEST(moored_lay, whose_pipe_bears_on_side_rollers_is_said_to_have_other_equilibria) {
  Description d = moored();
  const auto prescribed = [&] {
    Model model = build_model(d);
    const ModelEquilibrium lay = solve_lay(model);
    return warn_of_side_roller_contact(d, recover_statics(model, *lay.solution));
  };
  EXPECT_FALSE(prescribed());  // lengths hold the barge in its place
  d.moorings->find = FindMooring::pose;
  const std::optional<Finding> finding = prescribed();
  ASSERT_TRUE(finding);
  // Which boxes bear differs between the equilibria, and rounding decides which of them is found.
  EXPECT_NE(finding->message.find("the pipe loads the side rollers of '"), std::string::npos) << finding->message;
  EXPECT_NE(finding->message.find(" kN)"), std::string::npos) << finding->message;
  d.environment.current.clear();  // the barge stays on the course of the pipe
  EXPECT_FALSE(prescribed());
}

TEST(moored_lay, a_pull_ahead_has_its_stages_with_the_pipe_on_board) {
  Description d = moored();
  d.operation.type = OperationType::pull_ahead;
  d.operation.distance = 12.0;
  Model model = build_model(d);
  const ModelEquilibrium lay = solve_lay(model);
  ASSERT_FALSE(lay.failure) << lay.failure->why;
  ASSERT_EQ(lay.moorings->stages.size(), 2u);
  EXPECT_NEAR(lay.moorings->stages.back().vessel.surge - lay.moorings->stages.front().vessel.surge, 12.0, 1e-6);
  EXPECT_EQ(lay.moorings->winches.size(), 8u);
}

}  // namespace
}  // namespace overbend
