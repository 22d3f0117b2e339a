#include "statics/solver/coupled_equilibrium.h"

#include <gtest/gtest.h>

#include <set>

#include "support/free_body.h"

namespace overbend {
namespace {

using namespace testing;

struct Rested {
  CoupledSolveReport report;
  SystemState state;
  Vec3 ground_force, body_force;  ///< Force of the ground on the cable, of springs and pull on the body.
};

Rested rested(const SpringBody& springs, double friction = 0.3, const CoupledSolveSettings& settings = {}) {
  System system = body_with_lines(springs, friction);
  system.surroundings = surroundings_at_rest(system);
  Assembly assembly(system);
  Rested out;
  out.state = drawn_out(system);
  out.report = solve_coupled_equilibrium(assembly, out.state, settings);
  const std::array<double, 6>& end = assembly.line(0).end_force(LineEnd::first);
  out.ground_force = Vec3(end[0], end[1], end[2]);
  const Vec6 original = springs.pull - springs.stiffness.cwiseProduct(out.state.bodies[0].h - springs.drawn);
  out.body_force = original.head<3>();
  return out;
}

TEST(solve_coupled_equilibrium, balances_all_forces_on_the_whole) {
  const Rested solved = rested(floating());
  ASSERT_TRUE(solved.report.converged) << solved.report.residual;
  EXPECT_EQ(solved.report.rounds, 0);
  const double weight = (3.0 * 10.0 + 1.2 * 4.0) * kGravity;
  EXPECT_LT((solved.ground_force + solved.body_force - weight * Vec3::UnitZ()).norm(), 1e-6 * weight);
  EXPECT_GT((solved.state.bodies[0].h - floating().drawn).norm(), 0.1);  // it has moved
}

// Without friction, which remembers the way.
TEST(solve_coupled_equilibrium, comes_to_the_same_rest_by_the_fallback) {
  CoupledSolveSettings fallback;
  fallback.max_iterations = 12;    // enough for lines on a held body,
  fallback.body_step.move = 0.02;  // but not for all at once from here
  fallback.max_rounds = 200;
  const Rested solved = rested(floating(), 0.0), slowly = rested(floating(), 0.0, fallback);
  ASSERT_TRUE(slowly.report.converged) << slowly.report.residual;
  EXPECT_GT(slowly.report.rounds, 0);
  EXPECT_LT((solved.state.bodies[0].h - slowly.state.bodies[0].h).norm(), 1e-7);
}

TEST(solve_coupled_equilibrium, leaves_freedoms_that_are_held) {
  System system = body_with_lines(floating());
  system.surroundings = surroundings_at_rest(system);
  Assembly assembly(system);
  assembly.hold_body(0, 5, true);
  SystemState state = drawn_out(system);
  EXPECT_TRUE(solve_coupled_equilibrium(assembly, state).converged);
  EXPECT_EQ(state.bodies[0].h(5), 0.0);
  EXPECT_GT(std::abs(assembly.body_residual()[5]), 1.0);
  EXPECT_TRUE(assembly.body_held(0, 5));
}

// An evaluation of the state that comes back is the second opinion: the last one on the way may have been of a try.
TEST(solve_coupled_equilibrium, reports_where_the_state_it_gives_up_at_is_out_of_balance) {
  System system = body_with_lines(floating(), 0.0);
  system.surroundings = surroundings_at_rest(system);
  Assembly assembly(system);
  std::set<int> lines;
  for (int iterations = 1; iterations < 6; ++iterations) {
    SystemState state = drawn_out(system);
    CoupledSolveSettings settings;
    settings.max_iterations = iterations;
    settings.max_rounds = iterations % 2;
    const CoupledSolveReport report = solve_coupled_equilibrium(assembly, state, settings);
    ASSERT_FALSE(report.converged) << iterations;
    const SystemState before = state;
    assembly.impose_ends(state);
    assembly.evaluate(state, before, {}, false);
    assembly.hold(false);
    EXPECT_NEAR(report.residual, assembly.relative_residual(), 1e-5 * report.residual) << iterations;  // rates are zero
    EXPECT_EQ(report.worst_place, assembly.worst_place()) << iterations;
    lines.insert(report.worst_place.first);
  }
  EXPECT_GE(lines.size(), 2u);  // or any place would do
}

}  // namespace
}  // namespace overbend
