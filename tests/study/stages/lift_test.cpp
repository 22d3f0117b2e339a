#include "study/stages/lift.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "base/constants.h"
#include "base/json.h"
#include "modelfile/reading/yaml_reader.h"
#include "resultfiles/static/case_summary.h"

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

}  // namespace
}  // namespace overbend
