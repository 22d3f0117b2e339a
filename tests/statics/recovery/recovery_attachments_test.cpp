#include "statics/recovery/recovery_attachments.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "base/constants.h"
#include "base/json.h"
#include "modelfile/reading/yaml_reader.h"
#include "statics/recovery/recovery.h"
#include "statics/solver/statics.h"

namespace overbend {
namespace {

const std::string kCases = std::string(OVERBEND_SOURCE_DIR) + "/validation/lift_cases/";

Description read_case(const std::string& name) {
  return read_model(kCases + name + ".yaml").description.value();
}

StaticResults solved(const Description& description) {
  const Model model = build_model(description);
  return recover_statics(model, solve_statics(model).solution.value());
}

void compare(const AttachedPlace& found, const Json& wanted) {
  const std::string name = wanted["name"];
  const auto near = [&](const char* key, double value, double share, double min_value) {
    const double reference = wanted[key];
    EXPECT_NEAR(value, reference, std::max(share * std::abs(reference), min_value)) << name << " " << key;
  };
  near("arc_length", found.from_top, 0.0, 1e-9);
  near("x", found.astern, 0.0, 0.02);
  near("z", found.p_W.z(), 0.0, 0.02);
  near("inclination", found.inclination, 0.0, 0.05 * kDegree);
  near("moment", found.moment, 5e-3, 50.0);
  near("tension_before", found.tension_before, 3e-3, 0.0);
  near("tension_after", found.tension_after, 3e-3, 0.0);
  near("shear_before", found.shear_before, 3e-3, 10.0);
  near("shear_after", found.shear_after, 3e-3, 10.0);
}

// Two formulations without common code agree on the numbers: collocation of the extensible elastica, a chain of links.
TEST(recovery_attachments, clumps_and_buoys_bend_the_pipe_as_in_an_independent_answer) {
  const Json wanted = read_json_file(kCases + "PB12-J.json");
  const StaticResults found = solved(read_case("PB12-J"));
  ASSERT_EQ(found.points.size(), wanted["points"].size());
  for (std::size_t i = 0; i < found.points.size(); ++i) compare(found.points[i].location, wanted["points"][i]);
  EXPECT_NEAR(found.bottom_tension, wanted["bottom_tension"].get<double>(), 100.0);
  EXPECT_NEAR(found.top_inclination, wanted["top_inclination"].get<double>(), 0.05 * kDegree);
  EXPECT_NEAR(found.bed->hogging_moment, wanted["largest_hogging_moment"]["value"].get<double>(), 100.0);
  ASSERT_EQ(found.bed->contacts.size(), 2u) << "one buoy lifts the pipe off the bed";
  EXPECT_NEAR(found.bed->contacts[0].x_to, wanted["on_bed"][0]["x_to"].get<double>(), 0.3);
  EXPECT_NEAR(found.bed->contacts[1].x_from, wanted["on_bed"][1]["x_from"].get<double>(), 0.3);
}

TEST(recovery_attachments, a_wire_holds_the_suspended_pipe_as_in_an_independent_answer) {
  const Json wanted = read_json_file(kCases + "LW12-J.json");
  const StaticResults found = solved(read_case("LW12-J"));
  ASSERT_EQ(found.wires.size(), 1u);
  const Json& wire = wanted["wires"][0];
  compare(found.wires[0].location, wire);
  EXPECT_NEAR(found.wires[0].tension_upper, wire["tension_upper"].get<double>(), 100.0);
  EXPECT_NEAR(found.wires[0].from_vertical_upper, wire["from_vertical_upper"].get<double>(), 0.05 * kDegree);
  EXPECT_NEAR(found.wires[0].force.z(), wire["force_on_pipe"]["z"].get<double>(), 100.0);
  EXPECT_NEAR(*found.wires[0].utilisation, wire["utilisation"].get<double>(), 2e-4);
  EXPECT_NEAR(found.touchdown.astern, wanted["touchdown"]["x"].get<double>(), 0.3);
}

TEST(recovery_attachments, do_not_depend_on_the_mesh) {
  for (const char* name : {"PB12-J", "LW12-J"}) {
    Description fine = read_case(name);
    fine.mesh.touchdown_element = 0.25;
    fine.mesh.max_element_length = 1.0;
    const StaticResults a = solved(read_case(name)), b = solved(fine);
    for (std::size_t i = 0; i < a.points.size(); ++i) {
      EXPECT_NEAR(a.points[i].location.moment, b.points[i].location.moment,
                  1e-3 * std::abs(b.points[i].location.moment) + 5.0);
    }
    for (std::size_t i = 0; i < a.wires.size(); ++i) {
      EXPECT_NEAR(a.wires[i].tension_upper, b.wires[i].tension_upper, 1e-3 * b.wires[i].tension_upper);
      EXPECT_NEAR(a.wires[i].location.moment, b.wires[i].location.moment,
                  1e-3 * std::abs(b.wires[i].location.moment) + 5.0);
    }
  }
}

// Sum of every force on the line, each by its own law.
TEST(recovery_attachments, are_in_the_balance_of_the_whole_line) {
  for (const char* name : {"PB12-J", "LW12-J"}) {
    const StaticResults found = solved(read_case(name));
    EXPECT_LT(found.global_residual, 1e-8) << name;
    EXPECT_GT(found.sum_attached.norm(), 4e3) << name;
  }
}

TEST(recovery_attachments, a_slack_wire_leaves_the_pipe_alone_and_is_reported) {
  Description slack = read_case("LW12-J"), bare = slack;
  slack.lines[0].segments[0].length = 95.0;
  bare.lines.clear();
  const StaticResults with = solved(slack), without = solved(bare);
  EXPECT_EQ(with.wires[0].tension_upper, 0.0);
  EXPECT_NEAR(with.bottom_tension, without.bottom_tension, 1.0);
  EXPECT_TRUE(std::ranges::any_of(with.findings,
                                  [](const Finding& finding) { return finding.code == FindingCode::davit_slack; }));
}

TEST(recovery_attachments, a_wire_that_bears_too_much_is_reported) {
  Description weak = read_case("LW12-J");
  weak.lines[0].segments[0].type.breaking_load = 10e3;
  const StaticResults found = solved(weak);
  EXPECT_TRUE(std::ranges::any_of(
      found.findings, [](const Finding& finding) { return finding.code == FindingCode::breaking_load_exceeded; }));
}

// The vessel's frame is turned and off the origin: the same wire from a point of the vessel.
TEST(recovery_attachments, a_wire_on_the_vessel_holds_as_one_on_the_same_place) {
  Description on_vessel = read_case("LW12-J");
  LineEndDescription& end = on_vessel.lines[0].first;
  end.kind = LineEndKind::body;
  end.body = "vessel";
  const VesselPose pose = build_model(on_vessel).mean_pose;
  end.at = pose.R_WV.transpose() * (end.at - pose.p_WV);
  const StaticResults a = solved(read_case("LW12-J")), b = solved(on_vessel);
  EXPECT_NEAR(a.wires[0].tension_upper, b.wires[0].tension_upper, 0.1);
}

LineTypeDescription& type_of_wire(Description& d) {
  return d.lines[0].segments[0].type;
}

// With hardly any weight the catenary is the straight wire.
TEST(recovery_attachments, a_line_with_a_little_weight_holds_as_one_without) {
  Description light = read_case("LW12-J");
  type_of_wire(light).weight_in_air = type_of_wire(light).weight_submerged = 1e-3;
  const StaticResults a = solved(read_case("LW12-J")), b = solved(light);
  EXPECT_NEAR(b.wires[0].tension_upper, a.wires[0].tension_upper, 1.0);
  EXPECT_NEAR(b.wires[0].location.moment, a.wires[0].location.moment, 10.0);
}

// Its weight is the difference of its ends' vertical forces, in the air and under water.
TEST(recovery_attachments, a_line_with_weight_is_suspended_between_its_ends) {
  for (const bool turned : {false, true}) {
    Description heavy = read_case("LW12-J");
    type_of_wire(heavy).weight_in_air = 60.0;
    type_of_wire(heavy).weight_submerged = 50.0;
    heavy.lines[0].first.at.x() -= 8.0;
    heavy.lines[0].segments[0].length = 84.2;
    if (turned) std::swap(heavy.lines[0].first, heavy.lines[0].second);
    const StaticResults found = solved(heavy);
    const LineResult& line = found.lines[0];
    const PipeWireResult& wire = found.wires[0];
    const double in_air = 9.0, under_water = 84.2 - in_air;  // nearly plumb, and hardly stretched
    EXPECT_NEAR((line.first.force + line.second.force).z(), 60.0 * in_air + 50.0 * under_water, 30.0);
    EXPECT_NEAR((line.first.force + line.second.force).head<2>().norm(), 0.0, 1.0);
    EXPECT_NEAR(wire.tension_upper - wire.tension_lower, 60.0 * in_air + 50.0 * under_water, 60.0);
    EXPECT_GT(wire.tension_lower, 1e3);
    EXPECT_LT(found.global_residual, 1e-8);
  }
}

}  // namespace
}  // namespace overbend
