#include "statics/solver/rest_together.h"

#include <gtest/gtest.h>

#include <set>

#include "support/free_body.h"

namespace overbend {
namespace {

using namespace testing;

struct Rested {
  RestReport report;
  SystemState state;
  Vec3 ground_force, body_force;  ///< Of the ground on the cable, of springs and pull on the body.
};

Rested rested(const SpringBody& springs, double friction = 0.3, const RestSettings& settings = {}) {
  System system = body_with_lines(springs, friction);
  system.surroundings = still(system);
  Assembly assembly(system);
  Rested out;
  out.state = drawn_out(system);
  out.report = rest_together(assembly, out.state, settings);
  const std::array<double, 6>& end = assembly.line(0).end_force(LineEnd::first);
  out.ground_force = Vec3(end[0], end[1], end[2]);
  const Vec6 own = springs.pull - springs.stiffness.cwiseProduct(out.state.bodies[0].h - springs.drawn);
  out.body_force = own.head<3>();
  return out;
}

TEST(rest_together, balances_all_forces_on_the_whole) {
  const Rested at = rested(floating());
  ASSERT_TRUE(at.report.converged) << at.report.residual;
  EXPECT_EQ(at.report.rounds, 0);
  const double weight = (3.0 * 10.0 + 1.2 * 4.0) * kGravity;
  EXPECT_LT((at.ground_force + at.body_force - weight * Vec3::UnitZ()).norm(), 1e-6 * weight);
  EXPECT_GT((at.state.bodies[0].h - floating().drawn).norm(), 0.1);  // it has moved
}

// Without friction, which remembers the way.
TEST(rest_together, comes_to_the_same_rest_by_the_fallback) {
  RestSettings fallback;
  fallback.max_iterations = 12;    // enough for lines on a held body,
  fallback.body_step.move = 0.02;  // but not for all at once from here
  fallback.max_rounds = 200;
  const Rested at = rested(floating(), 0.0), slowly = rested(floating(), 0.0, fallback);
  ASSERT_TRUE(slowly.report.converged) << slowly.report.residual;
  EXPECT_GT(slowly.report.rounds, 0);
  EXPECT_LT((at.state.bodies[0].h - slowly.state.bodies[0].h).norm(), 1e-7);
}

TEST(rest_together, leaves_freedoms_that_are_held) {
  System system = body_with_lines(floating());
  system.surroundings = still(system);
  Assembly assembly(system);
  assembly.hold_body(0, 5, true);
  SystemState state = drawn_out(system);
  EXPECT_TRUE(rest_together(assembly, state).converged);
  EXPECT_EQ(state.bodies[0].h(5), 0.0);
  EXPECT_GT(std::abs(assembly.body_residual()[5]), 1.0);
  EXPECT_TRUE(assembly.body_held(0, 5));
}

// An evaluation of the state that comes back is the second opinion: the last one on the way may have been of a try.
TEST(rest_together, tells_where_the_state_it_gives_up_at_is_out_of_balance) {
  System system = body_with_lines(floating(), 0.0);
  system.surroundings = still(system);
  Assembly assembly(system);
  std::set<int> lines;
  for (int iterations = 1; iterations < 6; ++iterations) {
    SystemState state = drawn_out(system);
    RestSettings settings;
    settings.max_iterations = iterations;
    settings.max_rounds = iterations % 2;
    const RestReport report = rest_together(assembly, state, settings);
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
