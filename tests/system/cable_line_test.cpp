/// Properties of a cable, and the positions of its nodes.
#include "system/cable_line.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "support/line_cases.h"

namespace overbend {
namespace {

CableParts chain_and_wire() {
  CableParts parts;
  parts.segments = {{"chain", 300.0, testing::cable_type(100.0, 0.13, 5e8, 2e3, 1025.0)},
                    {"wire", 700.0, testing::cable_type(16.3418, 0.0512, 165.48e6, 2e3, 1025.0)}};
  parts.points.resize(1);
  parts.points[0].at = 512.5;
  parts.points[0].net_force = -10e3;
  return parts;
}

TEST(cable_line, has_the_numbers_of_its_segments_and_their_water) {
  const Model model = build_model(testing::water_alone(1025.0, 100.0));
  const CableParts parts = chain_and_wire();
  const Line line = cable_line(model, parts, {}, Vec3::Zero(), Vec3(900.0, 0.0, 0.0));
  const LineElements& e = line.elements;
  const std::size_t last = static_cast<std::size_t>(e.count) - 1;
  EXPECT_DOUBLE_EQ(e.EA[0], 5e8);
  EXPECT_DOUBLE_EQ(e.EA[last], 165.48e6);
  EXPECT_NEAR(e.mass[last], 16.3418, 1e-12);
  EXPECT_NEAR(e.displaced_mass[last], 1025.0 * 0.25 * std::numbers::pi * 0.0512 * 0.0512, 1e-9);
  EXPECT_NEAR(e.radius[0], 0.065, 1e-12);
  EXPECT_NEAR(e.added_normal[0], e.displaced_mass[0], 1e-12);
  EXPECT_NEAR(e.drag_normal[0], 0.5 * 1025.0 * 1.2 * 0.13, 1e-9);
  EXPECT_NEAR(line.force_scale, kGravity * (300.0 * 100.0 + 700.0 * 16.3418) + 10e3, 1e-6);
  EXPECT_FALSE(line.on_rollers);
}

TEST(cable_line, has_nodes_where_segments_meet_and_at_points) {
  const CableParts parts = chain_and_wire();
  const LineMesh mesh = cable_mesh(parts, {150.0, std::nullopt});
  for (const double place : {0.0, 300.0, 512.5, 1000.0}) {
    EXPECT_EQ(std::count(mesh.s.begin(), mesh.s.end(), place), 1) << place;
  }
  std::vector<double> lengths;
  for (std::size_t e = 0; e < mesh.length.size(); ++e) {
    if (!mesh.joint(e)) lengths.push_back(mesh.length[e]);
  }
  const auto [min_value, max_value] = std::minmax_element(lengths.begin(), lengths.end());
  EXPECT_GT(*min_value, 15.0);
  EXPECT_LE(*max_value, 50.0);
  EXPECT_LE(lengths[lengths.size() / 5], 26.0);  // by touchdown
}

TEST(cable_line, has_short_elements_where_they_are_wanted_and_grows_away_from_there) {
  const CableParts parts = chain_and_wire();
  CableMesh wanted;
  wanted.fine = {{950.0, 1000.0, 5.0}};
  const LineMesh mesh = cable_mesh(parts, wanted);
  for (std::size_t e = 0; e < mesh.length.size(); ++e) {
    EXPECT_LE(mesh.length[e], mesh.s[e] >= 950.0 ? 5.0 * (1.0 + 1e-9) : 50.0) << e;
  }
  EXPECT_GT(mesh.length.front(), 40.0);
}

TEST(cable_line, has_a_joint_of_the_softer_segment_where_two_meet_and_at_points) {
  CableParts parts = chain_and_wire();
  LineMesh mesh = cable_mesh(parts, {});
  std::vector<std::pair<double, double>> joints;
  for (std::size_t e = 0; e < mesh.length.size(); ++e) {
    if (mesh.joint(e)) joints.emplace_back(mesh.s[e], mesh.s[e + 1]);
  }
  ASSERT_EQ(joints.size(), 2u);
  EXPECT_DOUBLE_EQ(joints[0].first, 300.0);  // in the wire
  EXPECT_NEAR(joints[0].second, 300.01, 1e-9);
  EXPECT_DOUBLE_EQ(joints[1].first, 512.5);
  std::swap(parts.segments[0].type, parts.segments[1].type);
  mesh = cable_mesh(parts, {});
  const std::size_t joint = static_cast<std::size_t>(std::find(mesh.s.begin(), mesh.s.end(), 300.0) - mesh.s.begin());
  EXPECT_TRUE(mesh.joint(joint - 1));
  EXPECT_EQ(mesh.section[joint - 1], 0);
  EXPECT_GT(mesh.min_neighbour_length(static_cast<int>(joint)), 15.0);
}

TEST(cable_line, has_a_last_element_as_long_as_its_winch_needs_up_to_the_next_point) {
  const CableParts parts = chain_and_wire();
  const LineMesh usual = cable_mesh(parts, {150.0, std::nullopt}),
                 longer = cable_mesh(parts, {150.0, std::nullopt, 120.0}),
                 whole = cable_mesh(parts, {150.0, std::nullopt, 900.0});
  EXPECT_LT(usual.length.back(), 120.0);
  EXPECT_GE(longer.length.back(), 120.0);
  EXPECT_LE(longer.length.back(), 120.0 + usual.length.back());
  EXPECT_NEAR(whole.length.back(), 1000.0 - 512.51, 1e-9);  // a clump stands there, and its joint
  EXPECT_EQ(longer.s.back(), usual.s.back());
}

TEST(cable_line, sinks_a_centimetre_into_a_soft_bed_and_keeps_a_hard_one) {
  Description d = testing::water_alone(1025.0, 100.0);
  const CableParts parts = chain_and_wire();
  const double w = parts.segments[0].type.weight_submerged;
  for (const auto& [given, expected] : {std::pair{1e3, w / 0.01}, {1e6, 1e6}}) {
    d.environment.seabed.stiffness = given;
    const Model model = build_model(d);
    const LineEnvironment env = cable_environment(model, parts, Vec3::Zero(), Vec3(30.0, 40.0, 0.0));
    EXPECT_NEAR(env.bed_stiffness, expected, 1e-9 * expected);
    EXPECT_DOUBLE_EQ(env.bed_stick, given);
    EXPECT_NEAR(env.bed_along[0], 0.6, 1e-15);
    EXPECT_NEAR(env.route_normal[0], -0.8, 1e-15);
  }
}

TEST(cable_line, takes_the_friction_of_its_type_before_that_of_the_bed) {
  Description d = testing::water_alone(1025.0, 100.0);
  d.environment.seabed.friction_axial = 0.3;
  const Model model = build_model(d);
  CableParts parts = chain_and_wire();
  EXPECT_DOUBLE_EQ(cable_environment(model, parts, Vec3::Zero(), Vec3::UnitX()).bed_friction_axial, 0.3);
  parts.segments[0].type.friction = 1.0;
  EXPECT_DOUBLE_EQ(cable_environment(model, parts, Vec3::Zero(), Vec3::UnitX()).bed_friction_axial, 1.0);
}

TEST(cable_line, without_bending_stiffness_has_a_little) {
  const Model model = build_model(testing::water_alone(1025.0, 100.0));
  CableParts parts = chain_and_wire();
  parts.segments[0].type.bending_stiffness = 0.0;
  const Line line = cable_line(model, parts, {}, Vec3::Zero(), Vec3(900.0, 0.0, 0.0));
  EXPECT_GT(line.elements.EI[0], 0.0);
  EXPECT_LT(line.elements.EI[0], 5e8 * 0.13 * 0.13 / 1e4);
}

}  // namespace
}  // namespace overbend
