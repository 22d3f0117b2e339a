#include "model/vessel/stinger_rotation.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "support/fixtures.h"

namespace overbend {
namespace {

constexpr double kPipeRadius = 0.2445;

/// A ramp box, and a stinger of two sections with a box and a V row each.
Description two_sections() {
  Description d = testing::plain_description();
  d.supports = {};
  RollerKindDescription& kind = d.rollers.emplace_back();
  kind.name = "v";
  kind.bottom = {0.15, 0.6};
  kind.sides = SideRollerDescription{0.12, 0.6, 1.0, 0.05};
  for (int i = 0; i < 3; ++i) {
    BoxDescription box;
    box.structure = i == 0 ? Structure::ramp : Structure::stinger;
    box.x = 10.0 * (i - 1) + 5.0;
    box.z = -0.5 - 0.05 * box.x;
    box.incline = 0.05 + 0.1 * i;
    box.length = 2.0;
    box.rows = 2;
    box.roller = "v";
    box.section = std::max(i - 1, 0);
    d.supports.boxes.push_back(box);
  }
  for (int i = 0; i < 2; ++i) {
    StingerSectionDescription& section = d.supports.sections.emplace_back();
    section.hinge = {10.0 * i, -1.5 - i};
  }
  return d;
}

TEST(stinger_turn, goes_about_the_hinge_with_the_tip_down) {
  Description d = two_sections();
  d.supports.sections.resize(1);
  d.supports.boxes[2].section = 0;
  const Supports drawn = place_supports(d, kPipeRadius);
  d.supports.sections[0].angle = 0.2;
  const Supports turned = place_supports(d, kPipeRadius);
  const Vec3 hinge = turned.sections[0].hinge_S;
  EXPECT_EQ(turned.sections[0].turned, 0.2);
  for (std::size_t i = 1; i < 3; ++i) {
    const Vec3 before = drawn.boxes[i].point_S - hinge, after = turned.boxes[i].point_S - hinge;
    EXPECT_NEAR(after.norm(), before.norm(), 1e-12);
    EXPECT_NEAR(std::atan2(before.z(), before.x()) - std::atan2(after.z(), after.x()), 0.2, 1e-12);
    EXPECT_NEAR(turned.boxes[i].inclination - drawn.boxes[i].inclination, 0.2, 1e-12);
  }
  EXPECT_EQ(turned.boxes[0].point_S, drawn.boxes[0].point_S);
  EXPECT_EQ(turned.boxes[0].section, -1);
}

TEST(stinger_turn, moves_rollers_as_parts_of_one_body) {
  const Supports drawn = place_supports(two_sections(), kPipeRadius);
  Supports turned = drawn;
  rotate_stinger(turned, {0.1, -0.3});
  const auto on = [](const Supports& s, std::size_t i) { return s.boxes[static_cast<std::size_t>(s.rollers[i].box)]; };
  for (std::size_t i = 0; i < drawn.rollers.size(); ++i) {
    const SupportBox support_box = on(drawn, i), another = on(turned, i);
    const Vec3 before = drawn.rollers[i].center_S - support_box.point_S,
               after = turned.rollers[i].center_S - another.point_S;
    EXPECT_NEAR(before.dot(support_box.direction_S), after.dot(another.direction_S), 1e-12);
    EXPECT_NEAR(before.dot(support_box.normal_S), after.dot(another.normal_S), 1e-12);
    EXPECT_NEAR(drawn.rollers[i].normal_S.dot(support_box.normal_S), turned.rollers[i].normal_S.dot(another.normal_S),
                1e-12);
    EXPECT_NEAR(drawn.rollers[i].axis_S.dot(support_box.normal_S), turned.rollers[i].axis_S.dot(another.normal_S),
                1e-12);
  }
}

TEST(stinger_turn, takes_the_hinge_of_the_next_section_along) {
  const Supports drawn = place_supports(two_sections(), kPipeRadius);
  Supports turned = drawn;
  rotate_stinger(turned, {0.1, -0.3});
  const StingerSection &first = turned.sections[0], &second = turned.sections[1];
  EXPECT_NEAR(second.turned, -0.2, 1e-15);
  const Vec3 arm = drawn.sections[1].hinge_S - drawn.sections[0].hinge_S;
  EXPECT_LT((second.hinge_S - first.hinge_S - rotated_down(arm, 0.1)).norm(), 1e-12);
  const Vec3 tip = drawn.boxes[2].point_S - drawn.sections[1].hinge_S;
  EXPECT_LT((turned.boxes[2].point_S - second.hinge_S - rotated_down(tip, -0.2)).norm(), 1e-12);
}

TEST(stinger_turn, depends_on_the_angles_and_not_on_the_way) {
  const Supports drawn = place_supports(two_sections(), kPipeRadius);
  Supports once = drawn, twice = drawn;
  rotate_stinger(once, {0.1, 0.2});
  rotate_stinger(twice, {-0.4, 0.5});
  rotate_stinger(twice, {0.1, 0.2});
  for (std::size_t i = 0; i < once.rollers.size(); ++i) {
    EXPECT_LT((once.rollers[i].center_S - twice.rollers[i].center_S).norm(), 1e-13);
  }
}

TEST(stinger_turn, carries_points_of_a_section_as_its_boxes) {
  const Description d = two_sections();
  Supports turned = place_supports(d, kPipeRadius);
  rotate_stinger(turned, {0.15, 0.05});
  const BoxDescription& box = d.supports.boxes[2];
  const Vec3 point = point_on_section(d.supports.sections[1], turned.sections[1], {box.x, box.z}, 0.7);
  EXPECT_LT((point - turned.boxes[2].point_S - Vec3(0.0, 0.7, 0.0)).norm(), 1e-12);
}

}  // namespace
}  // namespace overbend
