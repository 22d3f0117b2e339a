#include "model/model.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "base/constants.h"
#include "support/fixtures.h"

namespace overbend {
namespace {

TEST(section, gives_the_printed_properties_of_the_sixteen_inch_pipe) {
  const Section pipe = derive_section("pipe", testing::sixteen_inch_pipe(), 10.05e3);
  EXPECT_NEAR(pipe.EA, 2859694.14e3, 5.0);  // [silva2009] table 4, half of the last printed digit
  EXPECT_NEAR(pipe.EI, 55894.90e3, 5.0);
  EXPECT_NEAR(pipe.weight_in_air, 2255.935, 1e-3);  // printed truncated
  EXPECT_NEAR(pipe.weight_submerged, 368.493, 1e-3);
  EXPECT_NEAR(pipe.outer_diameter, 0.489, 1e-12);
}

TEST(section, contents_weigh_in_air_and_under_water_alike) {
  SectionDescription pipe = testing::sixteen_inch_pipe();
  const Section empty = derive_section("empty", pipe, 10.05e3);
  pipe.contents_weight_density = 10.05e3;
  const Section flooded = derive_section("flooded", pipe, 10.05e3);
  EXPECT_NEAR(flooded.weight_in_air - empty.weight_in_air, 10.05e3 * empty.internal_area, 1e-9);
  EXPECT_NEAR(flooded.weight_submerged - empty.weight_submerged, 10.05e3 * empty.internal_area, 1e-9);
}

TEST(supports, points_on_a_circle_get_its_tangents) {
  std::vector<Eigen::Vector2d> points;
  for (const double angle : {2.0, 5.0, 9.0, 12.0}) {
    points.emplace_back(150.0 * std::sin(angle * kDegree), -150.0 * (1.0 - std::cos(angle * kDegree)));
  }
  const std::vector<double> dips = curve_inclinations(points, 0.0);
  EXPECT_NEAR(dips[0], 2.0 * kDegree, 1e-12);
  EXPECT_NEAR(dips[1], 5.0 * kDegree, 1e-12);
  EXPECT_NEAR(dips[3], 12.0 * kDegree, 1e-12);
}

/// One box of three V rows under the pipe.
Description one_box() {
  Description d = testing::plain_description();
  d.rollers.push_back(
      {"v", {0.15, 0.6}, SideRollerDescription{0.15, 0.6, 60.0 * kDegree, 0.05}, std::nullopt, 0.0, 0.0, 0.5});
  BoxDescription box;
  box.name = "box";
  box.x = 10.0;
  box.z = -2.0;
  box.length = 3.0;
  box.rows = 3;
  box.roller = "v";
  box.incline = 10.0 * kDegree;
  d.supports.boxes.push_back(box);
  return d;
}

TEST(supports, rows_stand_evenly_on_the_box_axis) {
  const Supports s = place_supports(one_box(), 0.2445);
  ASSERT_EQ(s.rows.size(), 3U);
  EXPECT_NEAR((s.rows[0].point_S - s.rows[1].point_S).norm(), 1.0, 1e-12);
  EXPECT_NEAR(s.rows[2].point_S.x(), 10.0 + std::cos(10.0 * kDegree), 1e-12);
  EXPECT_NEAR(s.rows[2].point_S.z(), -2.0 - std::sin(10.0 * kDegree), 1e-12);
}

TEST(supports, a_centred_pipe_touches_the_bottom_roller_and_clears_the_sides_as_given) {
  const double radius = 0.2445;
  const Supports s = place_supports(one_box(), radius);
  const Vec3 axis_point = s.rows[1].point_S + radius * s.boxes[0].normal_S;
  for (const Roller& roller : s.rollers) {
    if (roller.row == 1) {
      const double gap = (axis_point - roller.face_middle_S()).dot(roller.normal_S) - radius;
      EXPECT_NEAR(gap, roller.position == RollerPosition::bottom ? 0.0 : 0.05, 1e-12);
      EXPECT_NEAR(roller.axis_S.dot(roller.normal_S), 0.0, 1e-12);
      EXPECT_NEAR(roller.axis_S.dot(s.boxes[0].direction_S), 0.0, 1e-12);
    }
  }
}

TEST(model, a_barge_heading_east_has_its_port_side_north_and_its_stern_west) {
  const Model m = build_model(one_box());
  EXPECT_NEAR(m.mean_pose.R_WV.col(1).y(), 1.0, 1e-12);
  const Vec3 shoe = point_from_ramp(m, m.mean_pose, Vec3::Zero());
  EXPECT_NEAR(shoe.x(), -60.0, 1e-12);
  EXPECT_NEAR(point_from_ramp(m, m.mean_pose, Vec3(5.0, 0.0, 0.0)).x(), -65.0, 1e-12);
  const auto is_port = [](const Roller& r) { return r.position == RollerPosition::port; };
  const Roller& port = *std::find_if(m.supports.rollers.begin(), m.supports.rollers.end(), is_port);
  EXPECT_GT(point_from_ramp(m, m.mean_pose, port.center_S).y(), 0.2);
}

TEST(model, bow_up_trim_lowers_the_stern) {
  Description d = one_box();
  d.vessel.trim = 1.0 * kDegree;
  const Model m = build_model(d);
  EXPECT_NEAR(point_from_ramp(m, m.mean_pose, Vec3::Zero()).z(), -60.0 * std::sin(1.0 * kDegree), 1e-12);
}

TEST(model, the_seabed_is_as_deep_as_given_at_the_stern_shoe_and_falls_as_given) {
  Description d = one_box();
  d.environment.seabed.slope = 2.0 * kDegree;
  d.environment.seabed.slope_towards = 1.5 * std::numbers::pi;  // west, astern
  const Model m = build_model(d);
  EXPECT_NEAR(m.seabed.surface.height(-60.0, 0.0), -89.0, 1e-12);
  EXPECT_NEAR(m.seabed.surface.height(-160.0, 50.0), -89.0 - 100.0 * std::tan(2.0 * kDegree), 1e-9);
}

TEST(model, segments_count_from_the_tensioner) {
  Description d = one_box();
  SegmentDescription heavy{"heavy", 24.0, d.pipe.section};
  d.pipe.segments = {{"thick", 12.0, d.pipe.section}, heavy};
  const Model m = build_model(d);
  EXPECT_EQ(m.section_at(5.0), 1);
  EXPECT_EQ(m.section_at(20.0), 2);
  EXPECT_EQ(m.section_at(40.0), 0);
}

TEST(model, stiff_coated_pipe_leaves_the_field_joints_bare) {
  Description d = one_box();
  d.pipe.section.joint->coated_stiffness = 1.3;
  const Model m = build_model(d);
  ASSERT_EQ(m.sections.size(), 2u);
  EXPECT_DOUBLE_EQ(m.sections[1].EI, 1.3 * m.sections[0].EI);
  EXPECT_EQ(m.sections[1].weight_in_air, m.sections[0].weight_in_air);
  EXPECT_EQ(m.section_at(5.6), 1);  // joints of 12 m, the first in the middle of it, 0.6 m bare
  EXPECT_EQ(m.section_at(6.0), 0);
  EXPECT_EQ(m.section_at(6.4), 1);
  EXPECT_EQ(m.section_at(18.0), 0);
  EXPECT_EQ(m.section_at(1000.0), 0);  // far behind the supports it makes no difference
  d.pipe.section.joint->first = 2.0;
  EXPECT_EQ(build_model(d).section_at(14.0), 0);
}

/// To name a stretch of the same pipe a segment changes nothing; one of another stiffness has its own.
TEST(model, stiff_coated_pipe_goes_on_through_segments) {
  Description d = one_box();
  d.pipe.section.joint->coated_stiffness = 1.3;
  const Model whole = build_model(d);
  d.pipe.segments = {{"same", 20.0, d.pipe.section}};
  const Model cut = build_model(d);
  const auto stiffness = [](const Model& m, double position) {
    return m.sections[static_cast<std::size_t>(m.section_at(position))].EI;
  };
  for (double position = 0.05; position < 100.0; position += 0.1) {
    EXPECT_EQ(stiffness(cut, position), stiffness(whole, position)) << position;
  }
  ASSERT_GT(cut.coated, 0);  // what a run feeds in is of the main section
  EXPECT_EQ(cut.sections[static_cast<std::size_t>(cut.coated)].EI, whole.sections[1].EI);
  d.pipe.segments[0].section.joint->coated_stiffness = 2.0;
  EXPECT_DOUBLE_EQ(stiffness(build_model(d), 10.0), 2.0 * whole.sections[0].EI);
  EXPECT_EQ(stiffness(build_model(d), 6.0), whole.sections[0].EI);
  EXPECT_EQ(stiffness(build_model(d), 21.0), whole.sections[1].EI);
}

}  // namespace
}  // namespace overbend
