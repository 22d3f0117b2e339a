#include "statics/rest_together.h"

#include <gtest/gtest.h>

#include "support/free_body.h"

namespace overbend {
namespace {

using namespace testing;

/// A body on springs with a heavy cable from the ground, and a rod clamped in it that lies on a roller of the body.
System body_with_lines(const SpringBody& springs, double friction = 0.3) {
  System system = rod_system({2e4, 1.0, 3.0, 3.0 * kGravity}, 10.0, 16);
  system.lines.push_back(rod_system({4000.0, 60.0, 1.2, 1.2 * kGravity}, 4.0, 8).lines[0]);
  system.lines[0].on_rollers = false;
  system.lines[0].force_scale = system.lines[1].force_scale = 300.0;
  system.attachments.push_back(system.attachments[1]);
  Attachment &ground = system.attachments[0], &cable = system.attachments[1], &rod = system.attachments[2];
  hold(ground, true, false);
  hold_on_body(cable, Vec3(9.9, 0.0, 0.0));
  hold_on_body(rod, Vec3(14.0, 3.0, 0.5));
  rod.line = 1;
  hold(rod, true, true);
  ContactLaw law;
  law.stiffness = 2e4;
  law.friction_axial = law.friction_lateral = friction;
  law.tangential_stiffness = 2e3;
  BodyRoller roller = roller_under(11.0, 0.01, law);
  roller.center_V += Vec3(0.0, 3.0, 0.5);
  system.bodies[0].rollers = {roller};
  system.bodies[0].cells = endless_cells();
  system.bodies[0].free = free_body(springs, Vec3(12.0, 1.5, 0.0));
  system.machine = -1;
  return system;
}

struct Rested {
  RestReport report;
  SystemState state;
  Vec3 ground_force, body_force;  ///< Of the ground on the cable, of springs and pull on the body.
};

Rested rested(const SpringBody& springs, double friction = 0.3, const RestSettings& settings = {}) {
  System system = body_with_lines(springs, friction);
  system.surroundings = still(system);
  Assembly assembly(system);
  const std::vector<double> cable = straight(system, Vec3::Zero(), Vec3::UnitX(), 0.01);
  std::vector<double> rod;
  for (const double s : system.lines[1].mesh.s) rod.insert(rod.end(), {10.1 + s, 3.0, 0.5, 1.0, 0.0, 0.0});
  Rested out;
  out.state = state_at_rest(system, {cable, rod}, 0.0);
  out.state.bodies[0].h.head<3>() = Vec3(12.1, 1.5, 0.0);
  out.report = rest_together(assembly, out.state, settings);
  const std::array<double, 6>& end = assembly.line(0).end_force(LineEnd::first);
  out.ground_force = Vec3(end[0], end[1], end[2]);
  const Vec6 own = springs.pull - springs.stiffness.cwiseProduct(out.state.bodies[0].h - springs.drawn);
  out.body_force = own.head<3>();
  return out;
}

SpringBody floating() {
  SpringBody springs;
  springs.stiffness << 100.0, 100.0, 4000.0, 9000.0, 9000.0, 5000.0;
  springs.drawn << 12.0, 1.5, 0.0, 0.0, 0.0, 0.0;
  springs.pull << 250.0, 60.0, 0.0, 0.0, 0.0, 0.0;
  return springs;
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
  fallback.max_iterations = 12;  // enough for lines on a held body,
  fallback.largest_move = 0.02;  // but not for all at once from here
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
  std::vector<double> rod;
  for (const double s : system.lines[1].mesh.s) rod.insert(rod.end(), {10.1 + s, 3.0, 0.5, 1.0, 0.0, 0.0});
  SystemState state = state_at_rest(system, {straight(system, Vec3::Zero(), Vec3::UnitX(), 0.01), rod}, 0.0);
  state.bodies[0].h.head<3>() = Vec3(12.1, 1.5, 0.0);
  EXPECT_TRUE(rest_together(assembly, state).converged);
  EXPECT_EQ(state.bodies[0].h(5), 0.0);
  EXPECT_GT(std::abs(assembly.body_residual()[5]), 1.0);
  EXPECT_TRUE(assembly.body_held(0, 5));
}

}  // namespace
}  // namespace overbend
