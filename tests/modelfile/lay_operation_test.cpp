// Operations on the line: cable, head, winch, anchor and stages as the file gives them.
#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "model/lay_stage.h"
#include "model/model.h"
#include "modelfile/model_texts.h"
#include "modelfile/moored_texts.h"
#include "modelfile/reading/yaml_reader.h"

namespace overbend {
namespace {

const std::string kCable =
    "cable: {diameter: 76 mm, weight_in_air: 240 N/m, weight_submerged: 205 N/m, axial_stiffness: 2.7e5 kN, "
    "breaking_load: 4200 kN}";
const std::string kHead = "head: {length: 6 m, weight_in_air: 40 kN, weight_submerged: 33 kN}";
const std::string kLaidCable =
    "cable: {diameter: 76 mm, weight_in_air: 240 N/m, weight_submerged: 205 N/m, axial_stiffness: 2.7e5 kN, "
    "length: 500 m}";

std::string abandonment(const std::string& more) {
  return "type: abandonment, " + kHead + ", " + kCable + ", " + more;
}

const std::string kWinch = "winch: {distance: 900 m, depth: 2 m}, ";

std::string pull(const std::string& more) {
  return "type: shore_pull, " + kHead + ", " + kCable + ", " + more;
}

std::string start_up(const std::string& more) {
  return "type: start_up, " + kHead + ", " + kLaidCable + ", " + more;
}

ModelReading read(const std::string& operation) {
  return read_model_text(testing::kGoodModel + "\noperation: {" + operation + "}\n", "model.yaml");
}

Description read_good(const std::string& operation) {
  const ModelReading reading = read(operation);
  for (const std::string& line : reading.diagnostics.lines(Severity::error)) ADD_FAILURE() << line;
  return reading.description.value_or(Description{});
}

TEST(lay_operation, keys_fill_the_description) {
  const Description d = read_good(abandonment(
      "winch: {x: -60 m, z: 1.4 m}, stages: [{cable_out: 60 m, tension: 420 kN}, {name: bed, cable_out: 150 m, "
      "bottom_tension: 80 kN}]"));
  const LayOperationDescription& lay = d.operation.lay;
  EXPECT_EQ(d.operation.type, OperationType::abandonment);
  ASSERT_TRUE(lay.head && lay.cable && lay.winch);
  EXPECT_EQ(lay.head->length, 6.0);
  EXPECT_EQ(lay.head->weight_in_air, 40e3);
  EXPECT_EQ(lay.head->weight_submerged, 33e3);
  EXPECT_FALSE(lay.head->section);
  EXPECT_EQ(lay.cable->diameter, 0.076);
  EXPECT_EQ(lay.cable->weight_submerged, 205.0);
  EXPECT_EQ(lay.cable->axial_stiffness, 2.7e8);
  EXPECT_EQ(lay.cable->breaking_load.value(), 4200e3);
  EXPECT_EQ(lay.cable->drag_normal, 1.2);
  EXPECT_EQ(lay.winch->x, -60.0);
  EXPECT_EQ(lay.winch->z, 1.4);
  ASSERT_EQ(lay.stages.size(), 2U);
  EXPECT_EQ(lay.stages[0].cable_out.value(), 60.0);
  EXPECT_EQ(lay.stages[0].tension.value(), 420e3);
  EXPECT_EQ(lay.stages[1].name, "bed");
  EXPECT_EQ(lay.stages[1].bottom_tension.value(), 80e3);
  EXPECT_FALSE(lay.stages[1].tension);
  EXPECT_TRUE(d.operation.stages.empty());  // those are of a moored vessel
}

TEST(lay_operation, a_stage_without_a_tension_has_that_of_the_tensioner) {
  const std::vector<LayStageDescription> stages = lay_stages(read_good(abandonment("stages: [{cable_out: 60 m}]")));
  ASSERT_EQ(stages.size(), 1U);
  EXPECT_EQ(stages[0].tension.value(), 250e3);
  EXPECT_EQ(stages[0].name, "stage 1");
}

TEST(lay_operation, a_heads_section_has_of_the_pipe_what_it_does_not_say) {
  const Description d = read_good(
      "type: lay_down, head: {length: 6 m, weight_in_air: 40 kN, weight_submerged: 33 kN, section: {steel: "
      "{wall_thickness: 25 mm}, hydrodynamics: {drag_normal: 1}}}, " +
      kCable + ", stages: [{cable_out: 60 m}]");
  const std::optional<SectionDescription>& section = d.operation.lay.head->section;
  ASSERT_TRUE(section);
  EXPECT_EQ(section->steel.wall_thickness, 0.025);
  EXPECT_EQ(section->steel.outside_diameter, d.pipe.section.steel.outside_diameter);
  EXPECT_EQ(section->coatings.size(), d.pipe.section.coatings.size());
  EXPECT_EQ(section->hydrodynamics.drag_normal, 1.0);
  EXPECT_FALSE(section->joint);  // a head has no field joints
}

TEST(lay_operation, stages_are_generated_at_even_steps) {
  const Description d =
      read_good(abandonment("stages: {from: 60 m, to: 160 m, steps: 4, tension: [400 kN, 300 kN, 280 kN]}"));
  ASSERT_TRUE(d.operation.lay.program);
  const std::vector<LayStageDescription> stages = lay_stages(d);
  ASSERT_EQ(stages.size(), 5U);
  EXPECT_EQ(stages[1].cable_out.value(), 85.0);
  EXPECT_EQ(stages[1].tension.value(), 350e3);
  EXPECT_EQ(stages[4].tension.value(), 280e3);
}

TEST(lay_operation, generated_stages_say_how_their_tension_is_chosen) {
  const auto program = [](const std::string& keys) {
    return read_good(abandonment("stages: {from: 60 m, to: 160 m, " + keys + "}")).operation.lay.program.value();
  };
  const StageProgram held = program("steps: 3");
  EXPECT_EQ(held.steps, 3);
  EXPECT_EQ(held.tension, StageTension::hold);
  EXPECT_TRUE(held.values.empty());
  const StageProgram bottom = program("tension: bottom, bottom_tension: 90 kN");
  EXPECT_EQ(bottom.steps, 10);
  EXPECT_EQ(bottom.tension, StageTension::bottom);
  EXPECT_EQ(bottom.bottom_tension.value(), 90e3);
  const StageProgram sought = program(
      "tension: seek, tension_from: 100 kN, tension_to: 500 kN, limits: {sagbend_strain: 0.15 %, tip_clearance: "
      "0.3 m, roller_load: 300 kN, sagbend_stress: 360 MPa, utilisation: 0.9}");
  EXPECT_EQ(sought.tension, StageTension::seek);
  EXPECT_EQ(sought.tension_to.value(), 500e3);
  EXPECT_NEAR(sought.limits.sagbend_strain.value(), 0.0015, 1e-15);
  EXPECT_EQ(sought.limits.tip_clearance.value(), 0.3);
  EXPECT_EQ(sought.limits.roller_load.value(), 300e3);
  EXPECT_EQ(sought.limits.sagbend_stress.value(), 360e6);
  EXPECT_EQ(sought.limits.utilisation, 0.9);
}

TEST(lay_operation, a_start_up_has_an_anchor_and_pipe_out) {
  const Description d =
      read_good(start_up("anchor: {depth: 88.962 m}, stages: [{pipe_out: 95 m, tension: 150 kN}, {pipe_out: 140 m}]"));
  ASSERT_TRUE(d.operation.lay.anchor);
  EXPECT_EQ(d.operation.lay.anchor->depth, 88.962);
  EXPECT_FALSE(d.operation.lay.anchor->distance);
  EXPECT_EQ(d.operation.lay.cable->length.value(), 500.0);
  EXPECT_EQ(d.operation.lay.stages[1].pipe_out.value(), 140.0);
}

TEST(lay_operation, a_start_up_to_an_anchor_in_its_place_has_no_tension_of_its_own) {
  const Description d = read_good(start_up("anchor: {depth: 88 m, distance: 700 m}, stages: [{pipe_out: 95 m}]"));
  const std::vector<LayStageDescription> stages = lay_stages(d);
  ASSERT_EQ(stages.size(), 1U);
  EXPECT_FALSE(stages[0].tension);
  const Description description = make_stage_description(d, stages[0]);
  EXPECT_FALSE(description.tensioner.tension);  // though the lay itself has one
  EXPECT_EQ(description.pipe.anchor.value(), 700.0);
  EXPECT_EQ(description.pipe.length.value(), 95.0 + 6.0 + 500.0);
}

TEST(lay_operation, a_move_needs_no_cable) {
  const Description d = read_good("type: move, stages: {from: 0 m, to: 12.2 m, steps: 4}");
  EXPECT_EQ(lay_stages(d).back().ahead.value(), 12.2);
}

TEST(lay_operation, the_model_without_a_stage_is_the_lay_as_such) {
  const Description d = read_good(abandonment("stages: [{cable_out: 60 m}]"));
  EXPECT_FALSE(d.stage);
  const Model model = build_model(d);
  EXPECT_TRUE(std::none_of(model.sections.begin(), model.sections.end(),
                           [](const Section& section) { return section.kind == SectionKind::cable; }));
}

TEST(lay_operation, a_stored_text_is_read_whatever_its_stages_hold) {
  const std::string text = testing::kGoodModel + "\noperation: {" +
                           abandonment("stages: [{cable_out: 60 m, parted: [a], loads: []}]") + "}\n";
  const ModelReading reading = read_stored_model(text, "model.yaml");
  ASSERT_TRUE(reading.description);
  EXPECT_EQ(reading.description->operation.lay.stages.size(), 1U);
}

struct Slip {
  std::string operation;
  const char *key, *expected_text;
};

TEST(lay_operation, a_pull_has_a_winch_at_a_distance_and_tensions_of_the_tensioner) {
  const Description d = read_good(pull(kWinch + "stages: {from: 100 m, to: 300 m, steps: 2, tension: 180 kN}"));
  EXPECT_EQ(d.operation.type, OperationType::shore_pull);
  EXPECT_EQ(d.operation.lay.winch->distance, 900.0);
  EXPECT_EQ(d.operation.lay.winch->depth, 2.0);
  EXPECT_FALSE(d.operation.lay.cable->friction.has_value());
  const std::vector<LayStageDescription> stages = lay_stages(d);
  ASSERT_EQ(stages.size(), 3U);
  for (const LayStageDescription& stage : stages) EXPECT_EQ(stage.tension.value(), 180e3);
  EXPECT_EQ(stages[1].pipe_out.value(), 200.0);
}

TEST(lay_operation, a_dragged_line_has_friction_of_its_rollers_the_way_it_goes_and_no_length_of_its_own) {
  const Description d = read_good(pull(kWinch + "stages: [{pipe_out: 95 m}]"));
  const Description stage = make_stage_description(d, lay_stages(d).front());
  EXPECT_TRUE(is_dragged(stage));
  EXPECT_FALSE(is_dragged(d));
  EXPECT_EQ(dragging_direction(stage), 1.0);
  EXPECT_EQ(stage.statics.roller_friction, RollerFriction::lay);
  EXPECT_FALSE(stage.pipe.length.has_value());
  const Model model = build_model(stage);
  EXPECT_EQ(model.kind_at(94.0), SectionKind::pipe);
  EXPECT_EQ(model.kind_at(98.0), SectionKind::head);
  EXPECT_EQ(model.kind_at(5000.0), SectionKind::cable);
}

TEST(lay_operation, every_slip_is_reported_once_with_its_key) {
  const std::string single = "stages: [{cable_out: 60 m}]";
  const std::string heavy = "head: {length: 6 m, weight_in_air: 40 kN, weight_submerged: 44 kN}";
  const Slip slips[] = {
      {"type: abandonment, " + kHead + ", " + single, "operation.cable", "abandonment requires it"},
      {"type: recovery, " + kCable + ", " + single, "operation.head", "recovery requires it"},
      {abandonment(""), "operation.stages", "missing"},
      {abandonment("stages: []"), "operation.stages", "at least one"},
      {abandonment("stages: [{tension: 300 kN}]"), "operation.stages[0].cable_out", "missing"},
      {abandonment("stages: [{cable_out: 0 m}]"), "operation.stages[0].cable_out", "above 0 m"},
      {abandonment("stages: [{cable_out: 60 m, pipe_out: 10 m}]"), "operation.stages[0].pipe_out", "a key of start_up"},
      {abandonment("stages: [{cable_out: 60 m, parted: [a]}]"), "operation.stages[0].parted", "a key of moored"},
      {abandonment("stages: [{cable_out: 60 m, tension: 300 kN, bottom_tension: 90 kN}]"),
       "operation.stages[0].bottom_tension", "one of them"},
      {abandonment("stages: [{cable_out: 60 m, tension: 4300 kN}]"), "operation.stages[0].tension", "breaking load"},
      {abandonment("stages: [{name: a, cable_out: 60 m}, {name: a, cable_out: 70 m}]"), "operation.stages[1].name",
       "a"},
      {abandonment("distance: 12 m, " + single), "operation.distance", "pull_ahead or anchor_plan"},
      {abandonment("anchor: {depth: 80 m}, " + single), "operation.anchor", "a key of start_up"},
      {abandonment("stages: {from: 60 m, to: 160 m, steps: 0}"), "operation.stages.steps", "from 1"},
      {abandonment("stages: {from: 60 m, to: 60 m}"), "operation.stages.to", "a length other than"},
      {abandonment("stages: {from: 0 m, to: 60 m}"), "operation.stages.from", "above 0 m"},
      {abandonment("stages: {from: 60 m}"), "operation.stages.to", "missing"},
      {abandonment("stages: {from: 60 m, to: 160 m, tension: sought}"), "operation.stages.tension", "seek"},
      {abandonment("stages: {from: 60 m, to: 160 m, tension: 4300 kN}"), "operation.stages.tension", "breaking load"},
      {abandonment("stages: {from: 60 m, to: 160 m, tension: -300 kN}"), "operation.stages.tension", "above 0 kN"},
      {abandonment("stages: {from: 60 m, to: 160 m, tension: []}"), "operation.stages.tension", "at least 1"},
      {abandonment("stages: {from: 60 m, to: 160 m, tension: bottom}"), "operation.stages.bottom_tension", "missing"},
      {abandonment("stages: {from: 60 m, to: 160 m, bottom_tension: 90 kN}"), "operation.stages.bottom_tension",
       "tension: bottom"},
      {abandonment("stages: {from: 60 m, to: 160 m, limits: {tip_clearance: 1 m}}"), "operation.stages.limits",
       "tension: seek"},
      {abandonment("stages: {from: 60 m, to: 160 m, tension: seek, tension_from: 90 kN, tension_to: 80 kN}"),
       "operation.stages.tension_to", "more than"},
      {"type: abandonment, " + heavy + ", " + kCable + ", " + single, "operation.head.weight_submerged", "in air"},
      {"type: abandonment, " + kHead + ", " + kLaidCable + ", " + single, "operation.cable.length", "cable_out"},
      {"type: start_up, " + kHead + ", " + kCable + ", anchor: {depth: 88 m}, stages: [{pipe_out: 95 m}]",
       "operation.cable.length", "missing"},
      {start_up("stages: [{pipe_out: 95 m}]"), "operation.anchor", "start_up requires it"},
      {start_up("anchor: {depth: 90 m}, stages: [{pipe_out: 95 m}]"), "operation.anchor.depth", "89 m"},
      {start_up("anchor: {depth: -1 m}, stages: [{pipe_out: 95 m}]"), "operation.anchor.depth", "above 0 m"},
      {start_up("anchor: {depth: 88 m, distance: 500 m}, stages: [{pipe_out: 95 m, tension: 150 kN}]"),
       "operation.stages[0].tension", "follows from the distance"},
      {start_up("anchor: {depth: 88 m}, winch: {x: 1 m, z: 1 m}, stages: [{pipe_out: 95 m}]"), "operation.winch",
       "a key of abandonment"},
      {abandonment("winch: {distance: 500 m, depth: 2 m}, " + single), "operation.winch.distance", "x and z"},
      {"type: shore_pull, " + kCable + ", winch: {distance: 900 m, depth: 2 m}, stages: [{pipe_out: 95 m}]",
       "operation.head", "shore_pull requires it"},
      {"type: shore_pull, " + kHead + ", winch: {distance: 900 m, depth: 2 m}, stages: [{pipe_out: 95 m}]",
       "operation.cable", "shore_pull requires it"},
      {pull("stages: [{pipe_out: 95 m}]"), "operation.winch", "shore_pull requires it"},
      {pull("winch: {distance: 900 m}, stages: [{pipe_out: 95 m}]"), "operation.winch.depth", "missing"},
      {pull("winch: {distance: 900 m, depth: 2 m, x: 3 m}, stages: [{pipe_out: 95 m}]"), "operation.winch.x",
       "distance and depth"},
      {pull("winch: {distance: 900 m, depth: 90 m}, stages: [{pipe_out: 95 m}]"), "operation.winch.depth", "89 m"},
      {pull(kWinch + "stages: [{pipe_out: 95 m}, {pipe_out: 950 m}]"), "operation.stages[1].pipe_out", "has passed"},
      {pull(kWinch + "stages: {from: 100 m, to: 950 m}"), "operation.stages.to", "has passed"},
      {pull(kWinch + "stages: [{pipe_out: 95 m, tension: -10 kN}]"), "operation.stages[0].tension", "above 0 kN"},
      {pull(kWinch + "stages: [{pipe_out: 95 m, tension: 0 kN}]"), "operation.stages[0].tension", "above 0 kN"},
      {pull(kWinch + "stages: {from: 100 m, to: 300 m, tension: 0 kN}"), "operation.stages.tension", "above 0 kN"},
      {pull(kWinch + "stages: [{cable_out: 95 m, pipe_out: 90 m}]"), "operation.stages[0].cable_out",
       "a key of abandonment"},
      {"type: shore_pull, " + kHead + ", " + kLaidCable + ", " + kWinch + "stages: [{pipe_out: 95 m}]",
       "operation.cable.length", "operation.stages[0].pipe_out"},
      {"type: abandonment, " + kHead +
           ", cable: {diameter: 76 mm, weight_in_air: 240 N/m, weight_submerged: 205 N/m, axial_stiffness: 2.7e5 kN, "
           "friction: 0.4}, " +
           single,
       "operation.cable.friction", "shore_pull and hold_back"},
      {"type: move, stages: [{cable_out: 1 m, ahead: 1 m}]", "operation.stages[0].cable_out", "a key of abandonment"},
      {"type: moored, stages: {from: 1 m, to: 2 m}", "moorings", "missing"},
  };
  for (const Slip& slip : slips) {
    SCOPED_TRACE(slip.operation);
    const ModelReading reading = read(slip.operation);
    EXPECT_FALSE(reading.description.has_value());
    const std::vector<Diagnostic> all = reading.diagnostics.sorted();
    const auto of_key = [&](const Diagnostic& d) { return d.severity == Severity::error && d.key == slip.key; };
    EXPECT_EQ(std::count_if(all.begin(), all.end(), of_key), 1) << slip.key;
    for (const Diagnostic& d : all) {
      if (!of_key(d)) continue;
      EXPECT_NE((d.found + d.expected + d.hint).find(slip.expected_text), std::string::npos)
          << d.found << " | " << d.expected << " | " << d.hint;
      EXPECT_GT(d.line, 0);
    }
  }
}

TEST(lay_operation, moored_stages_are_no_program) {
  std::string text = testing::kMoored;
  text = text.substr(0, text.find("operation:")) + "operation: {type: moored, stages: {from: 1 m, to: 2 m}}\n";
  const ModelReading reading = read_model_text(text, "model.yaml");
  ASSERT_EQ(reading.diagnostics.error_count(), 1);
  EXPECT_EQ(reading.diagnostics.sorted().front().key, "operation.stages");
}

TEST(lay_operation, a_stage_without_any_tension_is_reported) {
  std::string text = testing::kGoodModel;
  text.replace(text.find("  tension: 250 kN\n"), 18, "");
  text.replace(text.find("pipe:\n"), 6, "pipe:\n  length: 900 m\n  anchor: 800 m\n");
  const auto errors = [&](const std::string& stage) {
    return read_model_text(text + "\noperation: {" + abandonment("stages: [{cable_out: 60 m" + stage + "}]") + "}\n",
                           "model.yaml")
        .diagnostics.lines(Severity::error);
  };
  EXPECT_TRUE(errors(", tension: 300 kN").empty());
  ASSERT_EQ(errors("").size(), 1U);
  EXPECT_NE(errors("").front().find("tensioner.tension"), std::string::npos) << errors("").front();
}

TEST(lay_operation, a_line_of_given_length_has_to_reach_beyond_the_longest_cable_and_the_head) {
  const auto errors = [](const std::string& length, const std::string& stages) {
    std::string text = testing::kGoodModel;
    text.replace(text.find("pipe:\n"), 6, "pipe:\n  length: " + length + "\n");
    text += "\noperation: {" + abandonment("stages: " + stages) + "}\n";
    return read_model_text(text, "model.yaml").diagnostics;
  };
  for (const char* stages : {"[{cable_out: 80 m}, {cable_out: 236 m}]", "{from: 236 m, to: 80 m}"}) {
    EXPECT_EQ(errors("242.1 m", stages).error_count(), 0) << stages;
    const Diagnostics rejected = errors("242 m", stages);
    ASSERT_EQ(rejected.error_count(), 1) << stages;
    EXPECT_EQ(rejected.sorted().front().key, "pipe.length");
    EXPECT_GT(rejected.sorted().front().line, 0);
    EXPECT_NE(rejected.lines(Severity::error).front().find("242 m"), std::string::npos);
    EXPECT_NE(rejected.lines(Severity::error).front().find("operation.stages"), std::string::npos);
  }
}

TEST(lay_operation, what_floats_is_only_warned_of) {
  const ModelReading reading =
      read("type: abandonment, head: {length: 6 m, weight_in_air: 40 kN, weight_submerged: -5 kN}, " + kCable +
           ", stages: [{cable_out: 60 m}]");
  ASSERT_TRUE(reading.description);
  const std::vector<std::string> warnings = messages(reading.description->findings);
  EXPECT_TRUE(std::any_of(warnings.begin(), warnings.end(),
                          [](const std::string& w) { return w.find("floats") != std::string::npos; }));
}

TEST(lay_operation, a_recovery_listed_upwards_is_warned_of) {
  const auto warned = [](const std::string& stages) {
    const Description d = read_good("type: recovery, " + kHead + ", " + kCable + ", stages: " + stages);
    return std::ranges::any_of(messages(d.findings),
                               [](const std::string& w) { return w.find("reverse order") != std::string::npos; });
  };
  EXPECT_TRUE(warned("[{cable_out: 160 m}, {cable_out: 60 m}]"));
  EXPECT_FALSE(warned("[{cable_out: 60 m}, {cable_out: 160 m}]"));
}

TEST(lay_operation, the_reference_cases_are_read) {
  const std::string folder = std::string(OVERBEND_SOURCE_DIR) + "/validation/operation_cases/";
  for (const char* name : {"AR12-J", "AR16-S", "SU10-J", "SU16"}) {
    const ModelReading reading = read_model(folder + name + ".yaml");
    for (const std::string& line : reading.diagnostics.lines(Severity::error)) ADD_FAILURE() << line;
    ASSERT_TRUE(reading.description) << name;
    EXPECT_GE(lay_stages(*reading.description).size(), 5U) << name;
  }
}

}  // namespace
}  // namespace overbend
