#include "study/stages/lift.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "base/constants.h"
#include "base/json.h"
#include "modelfile/reading/yaml_reader.h"
#include "resultfiles/static/case_summary.h"
#include "study/run/static_run.h"

namespace overbend {
namespace {

const std::string kCases = std::string(OVERBEND_SOURCE_DIR) + "/validation/lift_cases/";

Description read_case(const std::string& name) {
  return read_model(kCases + name + ".yaml").description.value();
}

OperationResults solve(const Description& description) {
  return solve_lift(description, {});
}

/// What a value may differ by from one that two other formulations agree on; 0: it is not compared.
double allowed(const std::string& path, const std::string& key, double value) {
  const double size = std::abs(value);
  if (path.find("/gap/") != std::string::npos) return key == "angle" ? 0.05 * kDegree : 0.01;
  if (path.find("/join/") != std::string::npos) {
    if (key == "moment") return std::max(5e-3 * size, 100.0);
    return key == "z" ? 0.02 : std::max(300.0, 5e-3 * size);
  }
  if (key == "x" || key == "y" || key == "z") {
    return path.find("/force_on_pipe/") != std::string::npos ? std::max(100.0, 3e-3 * size) : 0.02;
  }
  if (key == "inclination") return 0.05 * kDegree;
  if (key == "horizontal_force" || key == "vertical_force") return 200.0;
  if (key == "value") return 5e-3 * size;
  // a moment near an inflection is the small difference of large ones: 0.1 % of what the pipe bears there
  if (key == "moment") return std::max(5e-3 * size, 500.0);
  if (key == "largest_bending_stress") return 3e-3 * size;
  if (key == "arc_length") return 0.3;
  if (key == "length") return 0.02;
  return std::max(150.0, 3e-3 * size);  // tensions, shear
}

void compare(const Json& wanted, const Json& found, const std::string& path, const std::string& key) {
  if (wanted.is_object()) {
    for (const auto& [name, value] : wanted.items()) {
      ASSERT_TRUE(found.contains(name)) << path << name;
      compare(value, found[name], path + name + "/", name);
    }
  } else if (wanted.is_number()) {
    EXPECT_NEAR(found.get<double>(), wanted.get<double>(), allowed(path, key, wanted.get<double>())) << path;
  }
}

class LiftCases : public ::testing::TestWithParam<const char*> {};

// Two formulations without common code agree on the numbers (collocation of the extensible elastica, a chain of links;
// CB3: closed form of the beam on elastic props).
TEST_P(LiftCases, agree_with_independent_answers) {
  const Json wanted = read_json_file(kCases + GetParam() + ".json")["stages"];
  const OperationResults results = solve(read_case(GetParam()));
  const Json found = operation_summary_json(results)["operation"]["stages"];
  ASSERT_EQ(found.size(), wanted.size());
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    ASSERT_TRUE(results.stages[i].lay) << wanted[i]["name"];
    compare(wanted[i], found[i], std::string(GetParam()) + "/" + wanted[i]["name"].get<std::string>() + "/", "");
  }
}

INSTANTIATE_TEST_SUITE_P(lift, LiftCases,
                         ::testing::Values("DL8-one", "DL12-three", "DL20-two", "DL20-three", "DL10-heavy-wire",
                                           "CB3-wires", "TI12-mitre", "TI12-closed"));

const LiftResults& last(const OperationResults& results) {
  return *results.stages.back().lay->lift;
}

TEST(lift, does_not_depend_on_where_elements_end) {
  Description d = read_case("DL8-one");
  const LiftResults own = last(solve(d));
  for (const double element : {0.31, 0.9}) {
    d.lines[0].element = element;
    const LiftResults other = last(solve(d));
    EXPECT_NEAR(other.davits[0].tension_upper, own.davits[0].tension_upper, 1e-3 * own.davits[0].tension_upper);
    EXPECT_NEAR(other.lines[0].bending.value, own.lines[0].bending.value, 1e-3 * own.lines[0].bending.value);
    EXPECT_NEAR(other.lines[0].first.at.place.z(), own.lines[0].first.at.place.z(), 2e-3);
  }
}

/// The same in another direction, and turned upside down in its order.
TEST(lift, does_not_depend_on_the_heading) {
  Description d = read_case("DL8-one");
  const LiftResults own = last(solve(d));
  const double turn = 0.7;  // to starboard
  d.vessel.heading += turn;
  const Mat3 turned = Eigen::AngleAxisd(-turn, Vec3::UnitZ()).toRotationMatrix();
  for (FreeLineDescription& line : d.lines) {
    for (LineEndDescription* end : {&line.first, &line.second}) {
      if (end->kind == LineEndKind::bed) {
        end->at = turned * end->at;
        end->direction = turned * end->direction;
      }
    }
  }
  const LiftResults other = last(solve(d));
  EXPECT_NEAR(other.davits[0].tension_upper, own.davits[0].tension_upper, 1e-5 * own.davits[0].tension_upper);
  EXPECT_NEAR(other.lines[0].sagging.value, own.lines[0].sagging.value, 1e-5 * own.lines[0].sagging.value);
}

// Whatever holds the pipe bears its weight: davits, bed and what it displaces.
TEST(lift, leaves_a_slack_wire_alone) {
  Description d = read_case("DL12-three");
  d.operation.lay.stages.resize(1);
  d.operation.lay.stages[0].lengths = {{"davit 1", 40.0}, {"davit 2", 12.0}, {"davit 3", 40.0}};
  const LiftResults lift = last(solve(d));
  EXPECT_EQ(lift.davits[0].tension_upper, 0.0);
  EXPECT_GT(lift.davits[1].tension_upper, 1e3);
  EXPECT_EQ(lift.davits[2].tension_upper, 0.0);
  EXPECT_TRUE(std::ranges::any_of(solve(d).stages[0].lay->findings,
                                  [](const Finding& finding) { return finding.code == FindingCode::davit_slack; }));
}

TEST(lift, with_friction_keeps_what_it_was_pulled_by) {
  Description d = read_case("DL8-one");
  d.operation.lay.stages.resize(2);
  const double free_of_friction = last(solve(d)).lines[0].second.horizontal_force;
  d.environment.seabed.friction_axial = d.environment.seabed.friction_lateral = 0.6;
  const LiftResults rubbing = last(solve(d));
  EXPECT_LT(std::abs(rubbing.lines[0].second.horizontal_force), 0.9 * std::abs(free_of_friction));
}

/// Of the check of stress, the first of a lift.
const CheckRow& stress_row(const OperationResults& results) {
  return results.stages.back().lay->checks.rows.front();
}

// Von Mises in closed form: the hoop stress of thin-walled pipe by Barlow's formula, of the fibre that is worse off.
TEST(lift, judges_the_stress_with_that_of_pressure) {
  Description d = read_case("DL8-one");
  const double empty = stress_row(solve(d)).demand;
  SectionDescription& pipe = *d.lines[0].segments[0].section;
  pipe.internal_pressure = 10e6;
  const OperationResults results = solve(d);
  const CheckRow& row = stress_row(results);
  EXPECT_GT(row.demand, 1.1 * empty);
  const LiftedLine& line = results.stages.back().lay->lift->lines[0];
  const auto node = std::ranges::find(line.nodes, row.s, [](const LiftedNode& one) { return one.at.arc_length; });
  const double wall = pipe.steel.wall_thickness, outside = pipe.steel.outside_diameter, bore = outside - 2.0 * wall;
  const double depth = std::max(-node->at.place.z(), 0.0);
  const double hoop = (10e6 * bore - d.environment.water_weight_density * depth * outside) / (2.0 * wall);
  const double area = 0.25 * 3.14159265358979 * (outside * outside - bore * bore);
  double worst = 0.0;
  for (const double bending : {node->stress, -node->stress}) {
    const double along = node->tension / area + bending;
    worst = std::max(worst, std::sqrt(along * along - along * hoop + hoop * hoop));
  }
  EXPECT_NEAR(row.demand, worst, 1e-6 * worst);
}

// A stretch with a thicker coating touches the bed where its own underside does.
TEST(lift, finds_the_bed_under_pipe_of_two_diameters) {
  Description d = read_case("DL8-one");
  LineSegmentDescription thick = d.lines[0].segments[0];
  const double length = *thick.length;
  thick.section->coatings.push_back({"concrete", 0.05, 24e3, {}});
  thick.length = 0.5 * length;
  d.lines[0].segments[0].length = 0.5 * length;
  d.lines[0].segments.push_back(thick);
  d.operation.lay.stages.resize(1);
  const LiftedLine line = last(solve(d)).lines[0];
  double lies = 0.0;
  for (const BedStretch& stretch : line.on_bed) lies += stretch.to - stretch.from;
  EXPECT_GT(lies, 0.4 * length);
  EXPECT_NEAR(line.on_bed.back().to, length, 1e-9);
  EXPECT_NEAR(line.suspended_length + lies, length, 1e-9);
}

// What it does not name is the line as drawn, though the stage before could not be.
TEST(lift, begins_with_the_lines_as_drawn) {
  Description d = read_case("DL12-three");
  d.operation.lay.stages.resize(1);
  d.operation.lay.stages[0].lengths = {{"davit 2", 1e-9}};
  d.operation.lay.stages[0].tensions = {{"davit 1", 1e13}};
  d.operation.lay.stages.emplace_back().name = "as drawn";
  const OperationResults results = solve(d);
  ASSERT_TRUE(results.stages[0].failure);
  for (const LiftedWire& wire : last(results).davits) {
    const auto line = std::ranges::find(d.lines, wire.name, &FreeLineDescription::name);
    EXPECT_NEAR(wire.length, *line->segments[0].length, 1e-9);
  }
}

TEST(lift, tells_a_stage_that_cannot_be_and_goes_on) {
  Description d = read_case("DL8-one");
  LayStageDescription impossible;
  impossible.name = "too short";
  impossible.lengths = {{"davit 1", 1e-3}};
  d.operation.lay.stages.insert(d.operation.lay.stages.begin() + 1, impossible);
  const OperationResults results = solve(d);
  for (const StageResult& stage : results.stages) {
    EXPECT_NE(stage.lay.has_value(), stage.failure.has_value());
  }
  EXPECT_TRUE(results.stages.back().lay);
}

// Collocation of the extensible elastica and a chain of links agree on this tension.
TEST(lift, tells_the_tension_at_a_weld) {
  const OperationResults results = solve(read_case("TI12-closed"));
  const LiftResults& raised = *results.stages[0].lay->lift;
  const LiftResults& welded = *results.stages[2].lay->lift;
  EXPECT_EQ(raised.lines[0].first.tension, 0.0);
  EXPECT_NEAR(welded.lines[0].first.tension, 6163.69, 300.0);
  EXPECT_NEAR(welded.lines[0].first.tension, welded.join->tension, 1.0);
}

/// The pipe of a lay as a line from where the tensioner holds it to where it ends on the bed.
Description as_line(const Description& lay, const StaticResults& laid) {
  Description d = lay;
  d.has_pipe = false;
  d.pipe = {};
  FreeLineDescription line;
  line.name = "pipe";
  line.first.at = laid.tensioner_W;
  line.second.kind = LineEndKind::bed;
  line.second.at = laid.anchor_W;
  line.second.clamped = true;
  line.second.direction = (laid.anchor_W - laid.tensioner_W).cwiseProduct(Vec3(1.0, 1.0, 0.0));
  LineSegmentDescription segment;
  segment.length = laid.total_length;
  segment.section = lay.pipe.section;
  const Section pipe = build_model(lay).pipe_section();
  segment.type.diameter = segment.type.volume_diameter = segment.type.drag_diameter = pipe.outer_diameter;
  segment.type.weight_in_air = pipe.weight_in_air;
  segment.type.weight_submerged = pipe.weight_submerged;
  segment.type.axial_stiffness = pipe.EA;
  segment.type.bending_stiffness = pipe.EI;
  segment.type.compression = true;
  line.segments = {segment};
  d.lines = {line};
  return d;
}

// A pipe is a line: written as one between the same ends it hangs with the same forces.
TEST(lift, hangs_a_pipe_written_as_a_line_as_the_lay_does) {
  Description lay = read_case("LW12-J");
  lay.lines.clear();
  Model pipe = build_model(lay);
  const StaticResults laid = run_statics(pipe).results.value();
  Model line = build_model(as_line(lay, laid));
  const StaticResults hung = run_statics(line).results.value();
  EXPECT_NEAR(hung.lines[0].first.tension, laid.top_tension, 1e-4 * laid.top_tension);
  EXPECT_NEAR(hung.lines[0].second.tension, laid.bottom_tension, 1e-3 * laid.bottom_tension);
}

}  // namespace
}  // namespace overbend
