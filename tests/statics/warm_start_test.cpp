#include <gtest/gtest.h>

#include <algorithm>
#include <functional>

#include "modelfile/reading/yaml_reader.h"
#include "statics/recovery/recovery.h"
#include "statics/solver/statics.h"

namespace overbend {
namespace {

Description bgl1() {
  return read_model(OVERBEND_SOURCE_DIR "/examples/bgl1.yaml").description.value();
}

StaticResults recover_outcome(const Model& model, const StaticOutcome& outcome) {
  return recover_statics(model, outcome.solution.value());
}

/// The position of a node changes no result by as much as is compared here: a start may keep its own mesh.
Description finely_meshed() {
  Description description = bgl1();
  description.mesh.overbend_element = 0.2;
  description.mesh.touchdown_element = 0.2;
  return description;
}

/// Solves a changed lay from the solution of the unchanged one, and from nothing; says that both agree and that the
/// change moved something.
void expect_that_the_start_does_not_matter(const std::function<void(Model&)>& change) {
  Model model = build_model(finely_meshed());
  const StaticOutcome before = solve_statics(model);
  change(model);
  const StaticOutcome cold = solve_statics(model), warm = solve_statics(model, &before.solution.value());
  const StaticResults from_nothing = recover_outcome(model, cold), from_last = recover_outcome(model, warm);
  EXPECT_NEAR(from_last.overbend->bending_stress.value, from_nothing.overbend->bending_stress.value, 1e3);
  EXPECT_NEAR(from_last.lay_back, from_nothing.lay_back, 1e-3);
  const std::vector<double>& q = warm.solution->state.q;
  const Vec3 top = Eigen::Map<const Vec3>(q.data() + q.size() - 6);
  EXPECT_TRUE(top.isApprox(from_nothing.tensioner_W, 1e-12));
}

Model with(const std::function<void(Description&)>& change) {
  Description description = finely_meshed();
  change(description);
  return build_model(description);
}

}  // namespace

TEST(warm_start, follows_a_tensioner_that_was_raised) {
  expect_that_the_start_does_not_matter([](Model& m) { m = with([](Description& d) { d.tensioner.z += 0.3; }); });
}

TEST(warm_start, follows_a_tensioner_that_was_moved_along) {
  expect_that_the_start_does_not_matter([](Model& m) { m = with([](Description& d) { d.tensioner.x += 0.5; }); });
}

TEST(warm_start, follows_a_guide_that_was_tilted) {
  expect_that_the_start_does_not_matter(
      [](Model& m) { m = with([](Description& d) { d.tensioner.incline -= 0.01; }); });
}

TEST(warm_start, follows_a_barge_that_was_turned) {
  expect_that_the_start_does_not_matter([](Model& m) { m = with([](Description& d) { d.vessel.heading += 0.05; }); });
}

TEST(warm_start, follows_a_barge_that_drifted_off_its_route) {
  expect_that_the_start_does_not_matter([](Model& m) { m.mean_pose.p_WV = Vec3(-0.8, 1.2, -0.02); });
}

TEST(warm_start, is_used_where_the_barge_drifted) {
  Model model = build_model(bgl1());
  const StaticOutcome before = solve_statics(model);
  model.mean_pose.p_WV = Vec3(-0.8, 1.2, -0.02);
  EXPECT_EQ(solve_statics(model, &before.solution.value()).solution->report.method, "newton, from the last solution");
}

TEST(warm_start, carries_the_pipe_over_the_supports_with_a_barge_that_drifted_and_needs_few_iterations) {
  Model model = build_model(bgl1());
  const StaticOutcome before = solve_statics(model);
  model.mean_pose.p_WV = Vec3(-0.8, 1.2, -0.02);
  const int iterations = solve_statics(model, &before.solution.value()).solution->report.iterations;
  EXPECT_LE(iterations, 8);
  EXPECT_LE(3 * iterations, solve_statics(model).solution->report.iterations);
}

TEST(warm_start, turns_the_laid_line_with_its_route_so_that_nothing_bends_at_its_far_end) {
  Description description = bgl1();
  const StaticOutcome before = solve_statics(build_model(description));
  description.vessel.heading += 0.05;
  const Model turned = build_model(description);
  const StaticOutcome after = solve_statics(turned, &before.solution.value());
  EXPECT_EQ(after.solution->report.method, "newton, from the last solution");
  EXPECT_LE(after.solution->report.iterations, 8);
  EXPECT_LT(recover_outcome(turned, after).stations.front().bending_moment, 1e3);  // 298 kNm if it kept its direction
}

TEST(warm_start, follows_a_line_of_another_given_length) {
  Description description = bgl1();
  description.environment.current.clear();
  const StaticSolution laid = solve_statics(build_model(description)).solution.value();
  const double length = laid.mesh.total_length();
  description.pipe.length = length;
  description.pipe.anchor = recover_statics(build_model(description), laid).anchor_W.x() * -1.0 - 60.0;
  description.tensioner.tension.reset();
  const StaticSolution before = solve_statics(build_model(description)).solution.value();
  description.pipe.length = length + 0.3;  // touchdown stays where the elements are short
  const Model longer = build_model(description);
  const StaticOutcome warm = solve_statics(longer, &before);
  EXPECT_NEAR(warm.solution->mesh.total_length(), length + 0.3, 1e-6);
  const double cold = recover_outcome(longer, solve_statics(longer)).top_tension;
  EXPECT_NEAR(recover_outcome(longer, warm).top_tension, cold, 1e-3 * cold);
}

TEST(warm_start, makes_the_elements_that_are_asked_for_now) {
  Description description = bgl1();
  const StaticSolution before = solve_statics(build_model(description)).solution.value();
  description.mesh.max_element_length = 1.0;
  const Model finer = build_model(description);
  const StaticSolution after = solve_statics(finer, &before).solution.value();
  EXPECT_LE(*std::max_element(after.mesh.length.begin(), after.mesh.length.end()), 1.0 + 1e-9);
}

TEST(warm_start, makes_another_mesh_where_touchdown_has_left_the_fine_zone_step_by_step) {
  Description description = bgl1();
  // Pushed aside, so taut a pipe climbs its side rollers in one way or another: two equilibria.
  description.environment.current.clear();
  description.mesh.max_element_length =
      2.0;  // stress is reported at nodes: by 0.2 % less where the peak lies between them
  StaticSolution static_solution = solve_statics(build_model(description)).solution.value();
  const std::vector<double> first = static_solution.mesh.s;
  const double from = *description.tensioner.tension;
  for (int step = 1; step <= 10; ++step) {
    description.tensioner.tension = from + 1e4 * step;
    static_solution = solve_statics(build_model(description), &static_solution).solution.value();
  }
  EXPECT_NE(static_solution.mesh.s, first);
  const Model model = build_model(description);
  const StaticResults warm = recover_statics(model, static_solution),
                      cold = recover_outcome(model, solve_statics(model));
  EXPECT_NEAR(warm.sagbend.bending_stress.value, cold.sagbend.bending_stress.value,
              1e-3 * cold.sagbend.bending_stress.value);
}

}  // namespace overbend
