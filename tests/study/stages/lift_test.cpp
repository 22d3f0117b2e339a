#include "study/stages/lift.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "base/constants.h"
#include "base/json.h"
#include "modelfile/reading/yaml_reader.h"
#include "resultfiles/stages/operation_reader.h"
#include "resultfiles/static/case_summary.h"
#include "resultfiles/static/check_tables.h"
#include "results/findings.h"
#include "study/run/recheck.h"
#include "study/run/static_analysis.h"
#include "study/stages/lay_operation.h"
#include "support/solved_case.h"

namespace overbend {
namespace {

const std::string kCases = std::string(OVERBEND_SOURCE_DIR) + "/validation/lift_cases/";

Description read_case(const std::string& name) {
  return read_model(kCases + name + ".yaml").description.value();
}

OperationResults solve(const Description& description) {
  return solve_lift(description, {});
}

/// Tolerance of a value against one that two other formulations agree on; 0: it is not compared.
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
  const LiftResults lift_results = last(solve(d));
  for (const double element : {0.31, 0.9}) {
    d.lines[0].element = element;
    const LiftResults second_lift_results = last(solve(d));
    EXPECT_NEAR(second_lift_results.davits[0].tension_upper, lift_results.davits[0].tension_upper,
                1e-3 * lift_results.davits[0].tension_upper);
    EXPECT_NEAR(second_lift_results.lines[0].bending.value, lift_results.lines[0].bending.value,
                1e-3 * lift_results.lines[0].bending.value);
    EXPECT_NEAR(second_lift_results.lines[0].first.location.place.z(), lift_results.lines[0].first.location.place.z(),
                2e-3);
  }
}

/// The same in another direction, and turned upside down in its order.
TEST(lift, does_not_depend_on_the_heading) {
  Description d = read_case("DL8-one");
  const LiftResults lift_results = last(solve(d));
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
  const LiftResults second_lift_results = last(solve(d));
  EXPECT_NEAR(second_lift_results.davits[0].tension_upper, lift_results.davits[0].tension_upper,
              1e-5 * lift_results.davits[0].tension_upper);
  EXPECT_NEAR(second_lift_results.lines[0].sagging.value, lift_results.lines[0].sagging.value,
              1e-5 * lift_results.lines[0].sagging.value);
}

// The supports carry the weight of the pipe: davits, bed and what it displaces.
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

const StaticResults& last_state(const OperationResults& results) {
  return *results.stages.back().lay;
}

const CheckRow& row_named(const StaticResults& state, const std::string& id, const std::string& line) {
  const auto row =
      std::ranges::find_if(state.checks.rows, [&](const CheckRow& r) { return r.id == id && r.line == line; });
  if (row == state.checks.rows.end()) throw std::runtime_error("no check " + id + " of " + line);
  return *row;
}

/// Pipe of DL8-one, its formulas written down once more.
struct Pipe {
  double D, t, inside_pressure, water;

  explicit Pipe(const Description& d)
      : D(d.lines[0].segments[0].section->steel.outside_diameter),
        t(d.lines[0].segments[0].section->steel.wall_thickness),
        inside_pressure(d.lines[0].segments[0].section->internal_pressure),
        water(d.environment.water_weight_density) {}
  double outside(const LiftedNode& node) const { return water * std::max(-node.location.place.z(), 0.0); }
  double area() const { return std::numbers::pi * (D - t) * t; }

  /// Lame and Hencky: thick wall, both fibres, both surfaces.
  double von_mises(const LiftedNode& node) const {
    const double ro = 0.5 * D, ri = ro - t, po = outside(node), pi = inside_pressure;
    const double true_tension = node.tension - po * std::numbers::pi * ro * ro + pi * std::numbers::pi * ri * ri;
    const double second_moment = 0.25 * std::numbers::pi * (std::pow(ro, 4) - std::pow(ri, 4));
    double worst = 0.0;
    for (const double r : {ri, ro}) {
      const double mean = (pi * ri * ri - po * ro * ro) / (ro * ro - ri * ri);
      const double part = (pi - po) * ri * ri * ro * ro / (r * r * (ro * ro - ri * ri));
      for (const double side : {-1.0, 1.0}) {
        const double axial = true_tension / area() + side * std::hypot(node.sagging, node.sideways) * r / second_moment;
        const double hoop = mean + part, radial = mean - part;
        worst = std::max(worst, std::sqrt(0.5 * (std::pow(axial - hoop, 2) + std::pow(hoop - radial, 2) +
                                                 std::pow(radial - axial, 2))));
      }
    }
    return worst;
  }

  /// DNV-ST-F101 5.4.6, static, functional load factor 1.2 (system effects), safety class low, UOE, X60.
  double load_controlled(const LiftedNode& node) const {
    const double fy = 0.96 * 414e6, fu = 0.96 * 517e6, gamma = 1.15 * 1.04, factor = 1.2;
    const double beta = (60.0 - D / t) / 90.0, alpha = 1.0 - beta + beta * fu / fy;
    const double m = gamma * factor * std::hypot(node.sagging, node.sideways) / (alpha * fy * (D - t) * (D - t) * t);
    const double axial = gamma * factor * node.tension / (alpha * fy * std::numbers::pi * (D - t) * t);
    const double q = gamma * std::max(outside(node) - inside_pressure, 0.0) / collapse(fy);
    return std::pow(m + axial * axial, 2) + q * q;
  }

  /// The cubic of 5.4.4 by bisection.
  double collapse(double fy) const {
    const double elastic = 2.0 * 207e9 * std::pow(t / D, 3) / (1.0 - 0.09), plastic = 2.0 * fy * 0.85 * t / D;
    double low = 0.0, high = std::min(elastic, plastic);
    for (int i = 0; i < 200; ++i) {
      const double p = 0.5 * (low + high);
      const double left = (elastic - p) * (plastic * plastic - p * p);
      (left > p * elastic * plastic * 0.005 * D / t ? low : high) = p;
    }
    return low;
  }
};

// The formulas of a laid pipe, with forces, moments and pressures of the line: evaluated apart from the program.
TEST(lift, judges_pipe_of_lines_by_the_formulas_of_a_laid_pipe) {
  const Description d = read_case("DL8-one");
  const StaticResults state = last_state(solve(d));
  const Pipe pipe(d);
  double stress = 0.0, load = 0.0, pressure = 0.0;
  for (const LiftedNode& node : state.lift->lines[0].nodes) {
    stress = std::max(stress, pipe.von_mises(node));
    load = std::max(load, pipe.load_controlled(node));
    pressure = std::max(pressure, pipe.outside(node));
  }
  EXPECT_NEAR(row_named(state, "dnv_equivalent_stress", "pipe").demand, stress, 1e-6 * stress);
  EXPECT_NEAR(row_named(state, "dnv_equivalent_stress", "pipe").capacity, 0.87 * 0.96 * 414e6, 1.0);
  EXPECT_NEAR(row_named(state, "dnv_load_controlled", "pipe").utilisation, load, 1e-5 * load);
  EXPECT_EQ(row_named(state, "dnv_collapse", "pipe").demand, pressure);
  for (const char* id : {"dnv_propagation", "api_collapse", "api_tension", "api_bending_pressure"}) {
    EXPECT_TRUE(row_named(state, id, "pipe").judged()) << id;
  }
}

TEST(lift, judges_the_stress_with_that_of_pressure) {
  Description d = read_case("DL8-one");
  d.operation.lay.stages.resize(1);
  d.lines[0].segments[0].section->internal_pressure = 10e6;
  const StaticResults state = last_state(solve(d));
  double stress = 0.0;
  for (const LiftedNode& node : state.lift->lines[0].nodes) stress = std::max(stress, Pipe(d).von_mises(node));
  EXPECT_NEAR(row_named(state, "dnv_equivalent_stress", "pipe").demand, stress, 1e-6 * stress);
}

TEST(lift, uses_pipe_alike_whatever_its_elements) {
  Description d = read_case("DL8-one");
  d.operation.lay.stages.resize(2);
  const double original = row_named(last_state(solve(d)), "dnv_load_controlled", "pipe").utilisation;
  for (const double element : {0.31, 0.9}) {
    d.lines[0].element = element;
    EXPECT_NEAR(row_named(last_state(solve(d)), "dnv_load_controlled", "pipe").utilisation, original, 5e-3 * original);
  }
}

/// The two sides of a place.
std::pair<LiftedNode, LiftedNode> sides(const LiftedLine& line, double arc_length) {
  const auto first = std::ranges::find_if(
      line.nodes, [&](const LiftedNode& node) { return std::abs(node.location.arc_length - arc_length) < 1e-6; });
  EXPECT_NE(first, line.nodes.end());
  return {*first, *(first + 1)};
}

TEST(lift, gives_both_sides_of_an_attachment_their_tension_and_stress) {
  const Description d = read_case("DL8-one");
  const StaticResults state = last_state(solve(d));
  const LiftedWire& wire = state.lift->davits[0];
  const auto [before, behind] = sides(state.lift->lines[0], 10.0);
  EXPECT_EQ(behind.location.arc_length, before.location.arc_length);
  EXPECT_NEAR(before.tension, wire.tension_before, 1e-9);
  EXPECT_NEAR(behind.tension, wire.tension_after, 1e-9);
  EXPECT_NEAR(behind.shear, wire.shear_after, 1e-9);
  EXPECT_GT(std::abs(behind.tension - before.tension), 1e3);
  const Pipe pipe(d);
  EXPECT_NEAR(before.von_mises, pipe.von_mises(before), 1e-6 * before.von_mises);
  EXPECT_NEAR(behind.von_mises, pipe.von_mises(behind), 1e-6 * behind.von_mises);
  EXPECT_GT(std::abs(behind.von_mises - before.von_mises), 1e3);
}

// The force that carries a clump is the difference of the forces on its two sides.
TEST(lift, gives_both_sides_of_a_clump_their_tension) {
  Description d = read_case("DL8-one");
  const double weight = 4e3;
  LinePointDescription clump;
  clump.name = "clamp";
  clump.at = 22.0;
  clump.mass = weight / kGravity;
  clump.net_force = -weight;
  d.lines[0].points.push_back(clump);
  const LiftedLine line = last(solve(d)).lines[0];
  const auto [before, behind] = sides(line, 22.0);
  ASSERT_EQ(behind.location.arc_length, before.location.arc_length);
  EXPECT_NEAR(std::hypot(behind.tension - before.tension, behind.shear - before.shear), weight, 1e-6 * weight);
  EXPECT_NEAR(behind.sagging, before.sagging, 1e-6);
}

TEST(lift, has_one_verdict_for_every_stage) {
  Description d = read_case("DL8-one");
  d.lines[0].segments[0].section->steel.yield_stress = 120e6;
  const OperationResults results = solve(d);
  const Json stages = operation_summary_json(results)["operation"]["stages"];
  bool any = false;
  for (std::size_t i = 0; i < results.stages.size(); ++i) {
    const StageResult& stage = results.stages[i];
    const double max_value = find_governing_check(stage.lay->checks)->utilisation;
    const bool exceeded = stage_verdict(stage).kind == VerdictKind::exceeded;
    EXPECT_EQ(exceeded, max_value > 1.0) << stage.stage.name;
    EXPECT_EQ(stages[i]["verdict"]["words"], stage_verdict(stage).headline);
    EXPECT_EQ(stages[i]["checks"]["worst"]["line"], find_governing_check(stage.lay->checks)->line);
    any = any || exceeded;
  }
  EXPECT_TRUE(any);
  EXPECT_EQ(operation_verdict(results).kind, VerdictKind::exceeded);
}

// The current's part is not found apart: none of the load effects may have the smaller factor.
TEST(lift, takes_all_load_effects_as_environmental_in_a_current) {
  Description d = read_case("DL8-one");
  d.operation.lay.stages.resize(1);
  const CheckRow at_rest = row_named(last_state(solve(d)), "dnv_load_controlled", "pipe");
  d.environment.current = {{0.0, 1e-6, 0.0}};
  const CheckRow row = row_named(last_state(solve(d)), "dnv_load_controlled", "pipe");
  EXPECT_NEAR(row.demand, 1.3 / 1.2 * at_rest.demand, 1e-5 * row.demand);
  d.checks.current_load = CurrentLoad::functional;
  EXPECT_NEAR(row_named(last_state(solve(d)), "dnv_load_controlled", "pipe").demand, at_rest.demand,
              1e-5 * at_rest.demand);
}

TEST(lift, names_wires_whose_breaking_load_is_not_given) {
  Description d = read_case("DL8-one");
  d.operation.lay.stages.resize(1);
  d.lines[1].segments[0].type.breaking_load.reset();
  const StaticResults state = last_state(solve(d));
  const auto row = std::ranges::find(state.checks.rows, "line_load", &CheckRow::id);
  ASSERT_NE(row, state.checks.rows.end());
  EXPECT_EQ(row->status, CheckStatus::not_done);
  EXPECT_NE(row->remark.find("davit 1"), std::string::npos);
}

// 900 m away neither wire nor pipe, straight and stretched, are long enough.
TEST(lift, rejects_a_stage_in_which_a_wire_cannot_reach) {
  Description d = read_case("DL8-one");
  EXPECT_FALSE(unsupported_in_operation(d));
  d.operation.lay.stages[2].vessel = VesselOffset{900.0, 0.0, 0.0};
  const std::optional<StaticFailure> failure = unsupported_in_operation(d);
  ASSERT_TRUE(failure);
  EXPECT_TRUE(failure->input);
  EXPECT_EQ(failure->key, "operation.stages[2]");
  EXPECT_NE(failure->what.find("davit 1"), std::string::npos) << failure->what;
  EXPECT_NE(failure->where.find(d.operation.lay.stages[2].name), std::string::npos) << failure->where;
}

TEST(lift, rejects_a_wire_that_would_carry_several_times_its_breaking_load_and_goes_on) {
  Description d = read_case("DL8-one");
  d.operation.lay.stages[1].lengths = {{"davit 1", 1e-3}};
  const OperationResults results = solve(d);
  ASSERT_TRUE(results.stages[1].failure);
  EXPECT_NE(results.stages[1].failure->where.find("davit 1"), std::string::npos);
  EXPECT_NE(results.stages[1].failure->why.find("times its breaking load"), std::string::npos);
  EXPECT_EQ(stage_verdict(results.stages[1]).headline, "NO EQUILIBRIUM");
  EXPECT_TRUE(results.stages.back().lay);
}

TEST(lift, reports_which_line_does_not_get_where_a_stage_wants_it) {
  Description d = read_case("DL8-one");
  d.operation.lay.stages.resize(1);
  d.operation.lay.stages[0].lengths.clear();
  d.operation.lay.stages[0].tensions = {{"davit 1", 1e13}};
  const OperationResults results = solve(d);
  ASSERT_TRUE(results.stages[0].failure);
  EXPECT_NE(results.stages[0].failure->where.find("davit 1"), std::string::npos);
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

// Values it does not name are those of the line as drawn, though the stage before could not be.
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

TEST(lift, reports_a_stage_that_cannot_be_and_goes_on) {
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
TEST(lift, reports_the_tension_at_a_weld) {
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
TEST(lift, suspends_a_pipe_written_as_a_line_as_the_lay_does) {
  Description lay = read_case("LW12-J");
  lay.lines.clear();
  Model pipe = build_model(lay);
  const StaticResults laid = run_statics(pipe).results.value();
  Model line = build_model(as_line(lay, laid));
  const StaticResults suspended_run = run_statics(line).results.value();
  EXPECT_NEAR(suspended_run.lines[0].first.tension, laid.top_tension, 1e-4 * laid.top_tension);
  EXPECT_NEAR(suspended_run.lines[0].second.tension, laid.bottom_tension, 1e-3 * laid.bottom_tension);
}

/// The table as scripts read it.
std::string whole_text(const CheckTable& table) {
  return checks_table(table) + calculation_sheet_table(table);
}

TEST(lift, writes_its_checks_and_lines_and_checks_what_is_stored_alike) {
  Description d = read_case("DL12-three");
  d.operation.lay.stages.resize(2);
  const OperationResults results = solve(d);
  const testing::TemporaryFolder folder;
  write_operation_run(results, d, folder.path() / "out");
  for (const char* file : {"checks.csv", "calculation_sheet.csv", "lines.csv", "stages.csv"}) {
    const std::string text = testing::file_text(folder.path() / "out" / file);
    EXPECT_NE(text.find("stage"), std::string::npos) << file;
    EXPECT_NE(text.find(results.stages[1].stage.name), std::string::npos) << file;
  }
  const std::vector<LineResult> lines =
      read_operation_results(folder.path() / "out/results.h5").results.stages[1].lay->lines;
  ASSERT_EQ(lines.size(), d.lines.size());
  EXPECT_EQ(lines.back().nodes.back().place, results.stages[1].lay->lines.back().nodes.back().place);
  const RecheckedOperation again = recheck_operation(folder.path() / "out/results.h5", {});
  for (std::size_t i = 0; i < results.stages.size(); ++i) {
    EXPECT_EQ(whole_text(again.results.stages[i].lay->checks), whole_text(results.stages[i].lay->checks));
  }
}

/// A barge on a wire to a tug against a steady force.
Description barge_on_a_wire(const std::string& load, const std::string& stages) {
  return read_model_text(
             "overbend: 1\n"
             "environment: {water_depth: 50 m, seabed: {stiffness: 100 kN/m^2}}\n"
             "vessel: {heading: 90 deg, length: 100 m, draught: 4 m, loads: [{force: {x: " +
                 load +
                 "}}],\n"
                 "  hydrostatics: {heave: 20 MN/m, roll: 1000 MN*m, pitch: 15000 MN*m}}\n"
                 "bodies: [{name: tug, place: {x: 260 m, y: 0 m}, heading: 90 deg}]\n"
                 "moorings: {types: {wire: {diameter: 80 mm, weight_in_air: 0 N/m, weight_submerged: 0 N/m, "
                 "axial_stiffness: 20 MN}}}\n"
                 "lines: [{name: hawser, type: wire, length: 200 m, ends: [{body: vessel, at: {x: 50 m, y: 0 m, z: 0 "
                 "m}}, "
                 "{body: tug, at: {x: 0 m, y: 0 m, z: 0 m}}]}]\n"
                 "operation: {type: lift, stages: [" +
                 stages + "]}\n",
             "wire.yaml")
      .description.value();
}

// It comes to where a short hawser reaches; held, it does not, and its tug is not where the barge is.
TEST(lift, rejects_a_short_hawser_to_a_tug_where_the_barge_is_held) {
  Description d = barge_on_a_wire("-300 kN", "{name: hauled, lengths: {hawser: 100 m}}");
  EXPECT_FALSE(find_unreachable_stage(d));
  d.vessel.hydrostatics.reset();
  const std::optional<StaticFailure> failure = find_unreachable_stage(d);
  ASSERT_TRUE(failure);
  EXPECT_NE(failure->what.find("cannot reach"), std::string::npos) << failure->what;
  d.operation.lay.stages[0].lengths[0].value = 180.0;
  EXPECT_FALSE(find_unreachable_stage(d));
}

TEST(lift, of_a_barge_that_floats_free_hauls_it_to_its_tug_and_follows_the_tug) {
  const OperationResults results = solve(
      barge_on_a_wire("-300 kN", "{name: hauled, lengths: {hawser: 150 m}}, {name: ahead, bodies: {tug: {x: 40 m}}}"));
  const double span = 150.0 * (1.0 + 300e3 / 20e6);
  const auto bow = [&](std::size_t stage) { return results.stages.at(stage).lay->bodies.at(0).place.x() + 50.0; };
  EXPECT_NEAR(bow(0), 260.0 - span, 1e-4);
  EXPECT_NEAR(bow(1), 300.0 - span, 1e-4);
  const BodyResult& tug = results.stages[1].lay->bodies.at(1);
  EXPECT_EQ(tug.name, "tug");
  EXPECT_NEAR(tug.place.x(), 300.0, 1e-9);
  EXPECT_NEAR(tug.surge, 40.0, 1e-9);
  EXPECT_NEAR(tug.force.x(), -300e3, 1e-2);
}

}  // namespace
}  // namespace overbend
