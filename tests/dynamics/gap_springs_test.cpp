/// The BGL-1 on one gap spring per box against the same on rollers.
#include <gtest/gtest.h>

#include <cmath>

#include "dynamics/setup/dynamic_setup.h"
#include "statics/recovery/recovery.h"
#include "support/fixtures.h"
#include "support/solved_case.h"

namespace overbend {
namespace {

Description bgl1(SupportContact contact) {
  Description d = read_model(OVERBEND_SOURCE_DIR "/examples/bgl1.yaml").description.value();
  for (BoxDescription& box : d.supports.boxes) box.rows = 1;
  d.supports.contact = contact;
  return d;
}

StaticResults solve_results(const Description& d) {
  const Model model = build_model(d);
  return recover_statics(model, solve_statics(model).solution.value());
}

TEST(gap_springs, carry_a_pipe_that_nothing_pushes_aside_as_boxes_of_a_single_row_do) {
  const auto solved = [](SupportContact contact) {
    Description d = bgl1(contact);
    d.environment.current.clear();
    return solve_results(d);
  };
  const StaticResults springs = solved(SupportContact::gap_springs), rollers = solved(SupportContact::rollers);
  ASSERT_EQ(springs.supports.size(), 13U);
  double max_value = 0.0;
  for (std::size_t i = 0; i < springs.supports.size(); ++i) {
    EXPECT_NEAR(springs.supports[i].vertical, rollers.supports[i].vertical, 1.0) << springs.supports[i].name;
    max_value = std::max(max_value, springs.supports[i].vertical);
  }
  EXPECT_GT(max_value, 30e3);
}

TEST(gap_springs, hold_a_pipe_that_the_current_pushes_aside_as_rollers_do_on_the_whole) {
  const StaticResults springs = solve_results(bgl1(SupportContact::gap_springs));
  const StaticResults rollers = solve_results(bgl1(SupportContact::rollers));
  double vertical[2] = {}, lateral[2] = {};
  bool neighbour = false;
  for (std::size_t i = 0; i < springs.supports.size(); ++i) {
    vertical[0] += springs.supports[i].vertical;
    vertical[1] += rollers.supports[i].vertical;
    lateral[0] += springs.supports[i].lateral;
    lateral[1] += rollers.supports[i].lateral;
    for (const RollerResult& spring : springs.supports[i].rows[0].rollers) {
      if (spring.position == RollerPosition::bottom) continue;
      // The clearance is used up and no more: what the contact gives under the push.
      EXPECT_GE(spring.separation, -springs.max_penetration * (1.0 + 1e-9));
      EXPECT_LT(springs.max_penetration, 5e-3);
      neighbour = neighbour || spring.reaction > 1e3;
    }
  }
  EXPECT_TRUE(neighbour);
  // Sloping side rollers lift the pipe and share the load otherwise; what hangs from the supports is nearly the same.
  EXPECT_NEAR(vertical[0], vertical[1], 0.01 * vertical[1]);
  EXPECT_NEAR(lateral[0], lateral[1], 0.03 * std::abs(lateral[1]));
  EXPECT_GT(std::abs(lateral[1]), 20e3);
}

TEST(gap_springs, give_one_row_for_each_box_however_many_rows_of_rollers_it_has) {
  Description d = bgl1(SupportContact::gap_springs);
  const StaticResults static_results = solve_results(d);
  for (BoxDescription& box : d.supports.boxes) box.rows = 3;
  const StaticResults three = solve_results(d);
  for (std::size_t i = 0; i < static_results.supports.size(); ++i) {
    ASSERT_EQ(three.supports[i].rows.size(), 1U);
    EXPECT_EQ(three.supports[i].rows[0].rollers.size(), 3U);
    EXPECT_EQ(three.supports[i].reaction, static_results.supports[i].reaction);
  }
}

/// Forces of the springs of one box on a straight pipe along it, off the middle of the box to port and up.
struct SpringForces {
  double bottom = 0.0, port = 0.0, starboard = 0.0;
};
SpringForces forces(double to_port, double up) {
  Description d = testing::plain_description();
  d.rollers.push_back({"v", {0.15, 0.6}, SideRollerDescription{0.15, 0.6, 1.0, 0.05}, 2e6, 0.1, 0.1, 0.5});
  BoxDescription box;
  box.x = 10.0;
  box.incline = 0.3;
  box.roller = "v";
  d.supports.boxes.push_back(box);
  d.supports.contact = SupportContact::gap_springs;
  const double radius = 0.2445;
  const Supports s = place_supports(d, radius);
  const SupportBox& support_box = s.boxes[0];
  const Vec3 middle =
      support_box.point_S + (radius + up) * support_box.normal_S - to_port * Vec3::UnitY();  // S has Y to starboard
  std::vector<double> q;
  for (const double along : {-1.0, 1.0}) {
    const Vec3 r = middle + along * support_box.direction_S;
    q.insert(q.end(), {r.x(), r.y(), r.z(), support_box.direction_S.x(), support_box.direction_S.y(),
                       support_box.direction_S.z()});
  }
  const std::vector<double> length{2.0};
  SpringForces result;
  for (const Roller& roller : s.rollers) {
    const PlacedRoller placed{roller.center_S,   roller.axis_S, roller.normal_S,
                              0.5 * roller.face, roller.radius, roller.stiffness};
    const ClosestPoint closest = closest_point(placed, q.data(), length.data(), 0, 1);
    EXPECT_TRUE(closest.found && !closest.beyond_face);
    const double gap = roller_distance(placed, closest).value - radius - roller.radius;
    double& force = roller.position == RollerPosition::bottom ? result.bottom
                    : roller.position == RollerPosition::port ? result.port
                                                              : result.starboard;
    force = roller.stiffness * std::max(0.0, -gap);
  }
  return result;
}

TEST(gap_springs, act_to_either_side_once_the_clearance_is_used_up) {
  EXPECT_NEAR(forces(0.049, 0.0).port, 0.0, 1e-6);
  EXPECT_NEAR(forces(0.06, 0.0).port, 0.01 * 2e6, 1e-6);
  EXPECT_NEAR(forces(0.06, 0.0).starboard, 0.0, 1e-6);
  EXPECT_NEAR(forces(-0.06, 0.0).starboard, 0.01 * 2e6, 1e-6);
  EXPECT_NEAR(forces(2.0, 0.5).port, 1.95 * 2e6, 1e-6);  // far off and lifted too
}

TEST(gap_springs, act_from_below_wherever_the_pipe_stands_across) {
  EXPECT_NEAR(forces(0.0, -0.003).bottom, 0.003 * 2e6, 1e-6);
  EXPECT_NEAR(forces(1.5, -0.003).bottom, 0.003 * 2e6, 1e-6);
  EXPECT_NEAR(forces(0.0, 0.001).bottom, 0.0, 1e-6);
}

}  // namespace
}  // namespace overbend
