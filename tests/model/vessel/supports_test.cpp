#include "model/vessel/supports.h"

#include <gtest/gtest.h>

#include <cmath>

#include "base/constants.h"
#include "support/fixtures.h"

namespace overbend {
namespace {

constexpr double kPipeRadius = 0.2445;

/// Two boxes of three V rows that lose energy, as gap springs.
Description two_boxes() {
  Description d = testing::plain_description();
  RollerKindDescription kind{"v", {0.15, 0.6}, SideRollerDescription{0.12, 0.6, 60.0 * kDegree, 0.05}, 3e6, 0.1,
                             0.3, 0.4};
  kind.damping = RollerDamping::textbook;
  d.rollers.push_back(kind);
  for (const double x : {10.0, 20.0}) {
    BoxDescription box;
    box.x = x;
    box.z = -0.1 * x;
    box.offset = 0.02;
    box.length = 3.0;
    box.rows = 3;
    box.roller = "v";
    box.incline = 10.0 * kDegree;
    d.supports.boxes.push_back(box);
  }
  d.supports.contact = SupportContact::gap_springs;
  return d;
}

TEST(gap_springs, stand_one_in_the_middle_of_each_box) {
  Description d = two_boxes();
  const Supports springs = place_supports(d, kPipeRadius);
  d.supports.contact = SupportContact::rollers;
  const Supports rollers = place_supports(d, kPipeRadius);
  ASSERT_EQ(springs.boxes.size(), 2U);
  ASSERT_EQ(springs.rows.size(), 2U);
  ASSERT_EQ(springs.rollers.size(), 6U);
  ASSERT_EQ(rollers.rows.size(), 6U);
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_EQ(springs.boxes[i].first_row, static_cast<int>(i));
    EXPECT_EQ(springs.boxes[i].row_count, 1);
    EXPECT_LT((springs.rows[i].point_S - springs.boxes[i].point_S).norm(), 1e-12);
    EXPECT_LT((springs.rows[i].point_S - rollers.rows[3 * i + 1].point_S).norm(), 1e-12);
  }
}

TEST(gap_springs, have_no_gap_below_the_pipe_and_the_clearance_of_the_side_rollers_next_to_it) {
  const Supports s = place_supports(two_boxes(), kPipeRadius);
  for (const Roller& roller : s.rollers) {
    const SupportBox& box = s.boxes[static_cast<std::size_t>(roller.box)];
    const Vec3 pipe_axis = box.point_S + kPipeRadius * box.normal_S;
    const double gap = (pipe_axis - roller.face_middle_S()).dot(roller.normal_S) - kPipeRadius;
    const bool bottom = roller.position == RollerPosition::bottom;
    EXPECT_NEAR(gap, bottom ? 0.0 : 0.05, 1e-12);
    // Below it acts along the box's normal, next to it across the vessel and neither up nor down.
    EXPECT_NEAR(roller.normal_S.dot(box.normal_S), bottom ? 1.0 : 0.0, 1e-12);
    EXPECT_NEAR(std::abs(roller.normal_S.y()), bottom ? 0.0 : 1.0, 1e-12);
  }
}

TEST(gap_springs, are_as_stiff_as_the_roller_and_lose_nothing) {
  for (const Roller& roller : place_supports(two_boxes(), kPipeRadius).rollers) {
    EXPECT_EQ(roller.stiffness, 3e6);
    EXPECT_EQ(roller.restitution, 1.0);
    EXPECT_EQ(roller.friction_axial, 0.0);
    EXPECT_EQ(roller.friction_lateral, 0.0);
  }
}

TEST(gap_springs, of_a_kind_without_sides_have_none) {
  Description d = two_boxes();
  d.rollers[0].sides.reset();
  const Supports s = place_supports(d, kPipeRadius);
  ASSERT_EQ(s.rollers.size(), 2U);
  EXPECT_EQ(s.rollers[0].position, RollerPosition::bottom);
}

TEST(supports, hand_the_options_of_their_kind_to_each_roller) {
  Description d = two_boxes();
  d.supports.contact = SupportContact::rollers;
  d.rollers[0].tangential_stiffness = 7e5;
  for (const Roller& roller : place_supports(d, kPipeRadius).rollers) {
    EXPECT_EQ(roller.damping, RollerDamping::textbook);
    EXPECT_EQ(roller.tangential_stiffness, 7e5);
    EXPECT_EQ(roller.restitution, 0.4);
  }
}

}  // namespace
}  // namespace overbend
