// Models of moorings, lines and floating hulls, without a pipe.
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <functional>
#include <numbers>
#include <sstream>

#include "base/constants.h"
#include "base/yaml_document.h"
#include "model/model.h"
#include "model/pipe/line_types.h"
#include "modelfile/model_texts.h"
#include "modelfile/moored_reading.h"
#include "modelfile/moored_texts.h"
#include "modelfile/reading/yaml_reader.h"
#include "modelfile/yaml/yaml_edit.h"

namespace overbend {
namespace {

using testing::expect_reported;
using testing::kLines;
using testing::kMoored;
using testing::ModelSlip;
using testing::read_good;
using testing::replaced;

TEST(moorings, a_vessel_on_lines_needs_no_pipe) {
  const Description d = read_good(kMoored);
  EXPECT_FALSE(d.has_pipe);
  EXPECT_TRUE(read_good(testing::kGoodModel).has_pipe);
  const Model model = build_model(d);
  EXPECT_TRUE(model.sections.empty());
}

TEST(moorings, what_was_assumed_of_lines_is_said) {
  const std::vector<std::string> list = texts(assumptions(build_model(read_good(kMoored))));
  const auto says = [&](const std::string& message) {
    return std::any_of(list.begin(), list.end(),
                       [&](const std::string& s) { return s.find(message) != std::string::npos; });
  };
  EXPECT_TRUE(says("'wire64' is a six-strand wire rope of 64 mm with a wire core: 16.34 kg/m, EA 165.5 MN"));
  EXPECT_TRUE(says("'chain76' is a studless chain R4 of 76 mm"));
  EXPECT_FALSE(says("'given'"));
  EXPECT_TRUE(says("fixed point of the vessel"));
  EXPECT_FALSE(says("stern shoe"));
  for (const std::string& line : texts(assumptions(build_model(read_good(kLines))))) {
    EXPECT_EQ(line.find("vessel"), std::string::npos) << line;
  }
}

TEST(moorings, a_vessel_whose_motion_is_prescribed_moves_ahead_without_them) {
  const std::string changed_text = testing::kGoodModel;
  const Description d = read_good(changed_text + "\noperation: {type: pull_ahead, distance: 12.2 m}\n");
  EXPECT_EQ(d.operation.type, OperationType::pull_ahead);
  EXPECT_EQ(d.operation.distance, 12.2);
}

TEST(moorings, keys_fill_the_description) {
  const Description d = read_good(kMoored);
  ASSERT_TRUE(d.moorings && d.moorings->lines.size() == 3U && d.moorings->winches.size() == 1U);
  const MooringLineDescription& bow = d.moorings->lines[0];
  EXPECT_EQ(bow.fairlead, Vec3(57.0, 15.0, 3.0));
  EXPECT_NEAR(bow.bearing.value(), 335.0 * kDegree, 1e-14);
  EXPECT_EQ(bow.tension.value(), 300e3);
  EXPECT_EQ(bow.winch, "main");
  ASSERT_EQ(bow.segments.size(), 1U);
  EXPECT_FALSE(bow.segments[0].length);
  EXPECT_EQ(bow.segments[0].type.bending_stiffness, 2e3);
  const MooringLineDescription& stern = d.moorings->lines[2];
  EXPECT_EQ(stern.anchor.value()[1], 20.0);
  EXPECT_EQ(stern.fails_at.value(), 60.0);
  EXPECT_EQ(stern.segments[0].length.value(), 1000.0);
  EXPECT_EQ(d.moorings->winches[0].drum.value(), 1500.0);
  EXPECT_EQ(d.moorings->objects[0].points[1].y(), 500.0);
  EXPECT_EQ(d.vessel.loads[0].force.x(), -205.6e3);
  EXPECT_NEAR(d.vessel.hydrostatics->pitch, 42799210e3, 1.0);
  EXPECT_EQ(d.operation.type, OperationType::moored);
  ASSERT_EQ(d.operation.stages.size(), 2U);
  EXPECT_EQ(d.operation.stages[1].parted, std::vector<std::string>{"stern"});
  EXPECT_EQ(d.operation.stages[1].loads[0].moment.z(), 8e6);
  EXPECT_TRUE(d.moorings->lines[1].anchor_holding.slides);
  EXPECT_EQ(d.moorings->lines[1].anchor_holding.holding.value(), 1500e3);
}

TEST(moorings, a_segment_has_all_numbers_of_the_type_it_names) {
  const Description d = read_good(kMoored);
  const LineTypeDescription& wire = d.moorings->lines[0].segments[0].type;
  EXPECT_EQ(wire.name, "wire64");
  EXPECT_NEAR(wire.weight_submerged, submerged_weight(wire_rope(0.064, RopeCore::wire), 10.05e3), 1e-9);
  EXPECT_EQ(wire.drag_normal, 1.8);
  const LineTypeDescription& chain = d.moorings->lines[1].segments[1].type;
  EXPECT_EQ(chain.friction.value(), 0.8);
  EXPECT_NEAR(chain.drag_diameter, 1.8 * 0.076, 1e-12);
  const LineTypeDescription& given = d.moorings->lines[2].segments[0].type;
  EXPECT_EQ(given.weight_submerged, 148.0);
  EXPECT_EQ(given.drag_diameter, 0.064);
  EXPECT_EQ(given.breaking_load.value(), 2600e3);
}

// Archimedes: what lifts is the displaced water less the weight.
TEST(moorings, clumps_and_buoys_displace_what_their_forces_say) {
  const Description d = read_good(kMoored);
  const std::vector<LinePointDescription>& points = d.moorings->lines[1].points;
  ASSERT_EQ(points.size(), 2U);
  EXPECT_EQ(points[0].kind, PointKind::clump);
  EXPECT_NEAR(points[0].net_force, -5000.0 * kGravity, 1e-9);
  EXPECT_EQ(points[1].name, "lifter");
  EXPECT_NEAR(points[1].volume * 10.05e3, 20e3 + 1000.0 * kGravity, 1e-9);
  EXPECT_NEAR(points[1].added_mass, 0.5 * points[1].volume * 10.05e3 / kGravity, 1e-9);
}

TEST(moorings, reference_models_are_read_as_they_are) {
  const std::string folder = std::string(OVERBEND_SOURCE_DIR) + "/validation/mooring_cases/";
  for (const auto& [name, lines] :
       {std::pair{"MO1-wire", 5U}, {"MO2-chain-wire", 4U}, {"MO8-sym", 8U}, {"MO8-pull-ahead", 8U}}) {
    const ModelReading reading = read_model(folder + name + ".yaml");
    ASSERT_TRUE(reading.description) << name;
    EXPECT_EQ(reading.description->moorings->lines.size(), lines) << name;
    EXPECT_TRUE(reading.description->findings.empty()) << messages(reading.description->findings).front();
  }
}

TEST(lines, keys_fill_the_description) {
  const Description d = read_good(kLines);
  EXPECT_FALSE(d.has_pipe);
  ASSERT_EQ(d.lines.size(), 2U);
  const FreeLineDescription& jumper = d.lines[0];
  EXPECT_EQ(jumper.first.at, Vec3(-100.0, 0.0, -55.0));
  EXPECT_EQ(jumper.second.amplitude, Vec3(10.0, 0.0, 0.0));
  EXPECT_EQ(jumper.second.period, 27.0);
  EXPECT_EQ(jumper.element.value(), 2.0);
  const LineTypeDescription& hose = jumper.segments[0].type;
  EXPECT_NEAR(hose.weight_in_air, 165.0 * kGravity, 1e-9);
  EXPECT_NEAR(hose.weight_submerged, 165.0 * kGravity - 10.05e3 * 0.25 * std::numbers::pi * 0.396 * 0.396, 1e-9);
  EXPECT_EQ(d.lines[1].first.kind, LineEndKind::bed);
  EXPECT_EQ(d.lines[1].second.kind, LineEndKind::water);
  EXPECT_TRUE(d.lines[1].second.clamped);
}

/// Paths of all scalars below a node, with what stands there.
void collect(const YamlNode& node, const std::string& path, std::vector<YamlChange>& found) {
  if (node.kind == YamlNode::Kind::scalar) found.push_back({path, YamlChange::Kind::scalar, node.text});
  for (const YamlEntry& entry : node.entries) {
    collect(entry.value, path.empty() ? entry.key : path + "." + entry.key, found);
  }
  for (std::size_t i = 0; i < node.items.size(); ++i) {
    collect(node.items[i], path + "[" + std::to_string(i) + "]", found);
  }
}

// As the page's form does: each value set to what it is.
TEST(moorings, every_value_can_be_set_where_it_stands) {
  for (const std::string& text : {kMoored, kLines}) {
    Diagnostics bad_inputs;
    std::vector<YamlChange> values;
    collect(*parse_yaml(text, "", bad_inputs), "", values);
    EXPECT_GT(values.size(), 20U);
    for (const YamlChange& value : values) EXPECT_EQ(edit_yaml(text, {value}), text) << value.path;
  }
}

TEST(moorings, every_slip_is_reported_once_with_key_and_remedy) {
  const std::string stern = "anchor: {x: -1050 m, y: 20 m}";
  const std::vector<ModelSlip> slips = {
      {"two directions", "bearing: 335 deg,", "bearing: 335 deg, azimuth: 20 deg,", "moorings.lines[0]",
       "azimuth and bearing"},
      {"no direction", "bearing: 335 deg, ", "", "moorings.lines[0]", "one of azimuth, bearing or anchor"},
      {"no distance", "anchor_distance: 1000 m, type: wire64", "type: wire64", "moorings.lines[0].anchor_distance",
       "missing"},
      {"anchor and distance", stern, stern + ", anchor_distance: 9 m", "moorings.lines[2].anchor_distance",
       "one of them"},
      {"length and tension", "tension: 300 kN", "tension: 300 kN, length: 1007 m", "moorings.lines[0].length",
       "a length and a tension"},
      {"neither", ", tension: 300 kN", "", "moorings.lines[0].length", "tension, from which it follows"},
      {"second length open", "type: chain76, length: 310 m", "type: chain76", "moorings.lines[1].segments[1].length",
       "only the length of the first"},
      {"unknown type", "type: given", "type: givn", "moorings.lines[2].type", "did you mean 'given'"},
      {"unknown winch", "winch: main", "winch: mian", "moorings.lines[0].winch", "'main'"},
      {"misspelt key", "winch: main", "winsch: main", "moorings.lines[0].winsch", "did you mean 'winch'"},
      {"type and property", "{type: wire64, length: 700 m}", "{type: wire64, length: 700 m, friction: 1}",
       "moorings.lines[1].segments[0].friction", "put the property into the type"},
      {"fairlead in the bed", "fairlead: {x: -57 m, y: 0 m, z: 3 m}", "fairlead: {x: -57 m, y: 0 m, z: -90 m}",
       "moorings.lines[2].fairlead.z", "above the seabed"},
      {"line too short", "type: given, length: 1000 m", "type: given, length: 900 m", "moorings.lines[2].length",
       "997.453 m from its fairlead to its anchor"},
      {"segments too short", "{type: wire64, length: 700 m}", "{type: wire64, length: 600 m}",
       "moorings.lines[1].segments", "too short to reach"},
      {"no segment in the list", "[{type: wire64, length: 700 m}, {name: chain, type: chain76, length: 310 m}]", "[]",
       "moorings.lines[1].segments", "at least 1"},
      {"fairlead in mm", "fairlead: {x: -57 m,", "fairlead: {x: -57 km,", "moorings.lines[2].fairlead.x",
       "far outside the vessel"},
      {"two of a name", "name: starboard bow", "name: port bow", "moorings.lines[1].name", "already used in line"},
      {"clump beyond the end", "at: 900 m", "at: 1900 m", "moorings.lines[1].clumps[0].at", "1010 m"},
      {"sliding without holding", "      anchor_holding: 1500 kN\n", "", "moorings.lines[1].anchor_holding", "slides"},
      {"numbers incomplete", "axial_stiffness: 1.9e5 kN, ", "", "moorings.types.given.axial_stiffness", "missing"},
      {"kind and number", "wire_rope: {diameter: 64 mm, core: wire}", "wire_rope: {diameter: 64 mm}, diameter: 1 mm",
       "moorings.types.wire64.diameter", "one of them"},
      {"a kind of the wrong shape", "chain: {diameter: 76 mm}", "wire_rope: {diameter: 64 mm}, chain: 5",
       "moorings.types.chain76.chain", "a group of keys"},
      {"two kinds", "chain: {diameter: 76 mm}", "chain: {diameter: 76 mm}, wire_rope: {diameter: 64 mm}",
       "moorings.types.chain76.chain", "one of them"},
      {"unknown line parted", "parted: [stern]", "parted: [starn]", "operation.stages[1].parted[0]", "'stern'"},
      {"stall below haul", "stall: 900 kN", "stall: 600 kN", "moorings.winches.main.stall", "at least haul"},
      {"bounds crossed", "working_load: 900 kN", "working_load: 900 kN\n  least_tension: 1 MN",
       "moorings.least_tension", "less than the working load"},
      {"distance of a moored vessel", "type: moored", "type: moored\n  distance: 12 m", "operation.distance",
       "pull_ahead"},
      {"anchor of a moored vessel", "type: moored", "type: moored\n  line: stern", "operation.line", "anchor_move"},
      {"held and floating", "  heading: 90 deg", "  heading: 90 deg\n  motion: fixed", "vessel.hydrostatics",
       "one of them"},
  };
  for (const ModelSlip& slip : slips) expect_reported(kMoored, slip);
}

/// The operation of the text in place of its stages.
std::string with_operation(const std::string& operation) {
  return kMoored.substr(0, kMoored.find("operation:")) + "operation: " + operation + "\n";
}

TEST(moorings, a_pull_ahead_has_a_shape_and_rests_between_its_moves) {
  const ModelReading reading = read_model_text(
      with_operation("{type: pull_ahead, distance: 12 m, moves: 3, wait: 4 min, shape: zero_vibration}"), "model.yaml");
  ASSERT_TRUE(reading.description);
  EXPECT_EQ(reading.description->operation.wait, 240.0);
  EXPECT_EQ(reading.description->operation.shape, MoveShape::zero_vibration);
}

TEST(moorings, an_anchor_is_moved_to_a_place_or_by_a_direction_and_a_distance) {
  const ModelReading place = read_model_text(
      with_operation("{type: anchor_move, line: stern, to: {x: -1500 m, y: 30 m}, test_tension: 800 kN}"),
      "model.yaml");
  ASSERT_TRUE(place.description);
  const AnchorMoveDescription& move = place.description->operation.anchor;
  EXPECT_EQ(move.line, "stern");
  EXPECT_EQ((*move.to)[0], -1500.0);
  EXPECT_EQ(move.handling_tension, 50e3);
  EXPECT_EQ(move.test_tension, 800e3);
  const struct {
    const char *operation, *key;
  } slips[] = {{"{type: anchor_move, line: stren, to: {x: 1 m, y: 2 m}}", "operation.line"},
               {"{type: anchor_move, to: {x: 1 m, y: 2 m}}", "operation.line"},
               {"{type: anchor_move, line: stern}", "operation.to"},
               {"{type: anchor_move, line: stern, bearing: 10 deg}", "operation.anchor_distance"},
               {"{type: anchor_move, line: stern, to: {x: 1 m, y: 2 m}, bearing: 10 deg}", "operation.to"},
               {"{type: pull_ahead, handling_tension: 50 kN}", "operation.handling_tension"}};
  for (const auto& slip : slips) {
    const ModelReading reading = read_model_text(with_operation(slip.operation), "model.yaml");
    ASSERT_GE(reading.diagnostics.error_count(), 1) << slip.operation;
    EXPECT_NE(reading.diagnostics.lines(Severity::error).at(0).find(slip.key), std::string::npos)
        << reading.diagnostics.lines(Severity::error).at(0);
  }
}

// One for each line that has none.
TEST(moorings, lengths_are_found_for_tensions_only) {
  const std::string text = replaced(kMoored, "working_load: 900 kN", "find: lengths");
  const ModelReading reading = read_model_text(text, "slip.yaml");
  EXPECT_EQ(reading.diagnostics.error_count(), 2);
  EXPECT_NE(reading.diagnostics.lines(Severity::error).at(0).find("moorings.lines[1].tension"), std::string::npos);
}

TEST(moorings, a_hull_that_floats_needs_three_lines) {
  const std::size_t from = kMoored.find("    - name: starboard bow"), to = kMoored.find("    - {name: stern");
  const std::string two = kMoored.substr(0, from) + kMoored.substr(to);
  expect_reported(replaced(two, "    chain76: {chain: {diameter: 76 mm}, friction: 0.8}\n", ""),
                  {"two lines", "draught: 5 m", "draught: 4 m", "moorings.lines", "at least three"});
}

TEST(moorings, loads_on_a_held_hull_are_rejected) {
  const std::size_t from = kMoored.find("  hydrostatics:"), to = kMoored.find("  loads:");
  expect_reported(kMoored.substr(0, from) + kMoored.substr(to),
                  {"held", "draught: 5 m", "draught: 4 m", "vessel.loads", "held"});
}

TEST(moorings, a_model_of_nothing_misses_its_pipe) {
  const std::string nothing = kMoored.substr(0, kMoored.find("vessel:"));
  const ModelReading reading = read_model_text(nothing, "slip.yaml");
  const std::vector<std::string> errors = reading.diagnostics.lines(Severity::error);
  ASSERT_EQ(errors.size(), 3U);
  for (const char* key : {" pipe: ", " tensioner: ", " vessel: "}) {
    EXPECT_TRUE(std::any_of(errors.begin(), errors.end(), [&](const std::string& e) {
      return e.find(key) != std::string::npos;
    })) << key;
  }
}

TEST(lines, every_slip_is_reported_once_with_key_and_remedy) {
  const std::vector<ModelSlip> slips = {
      {"no place", "{fixed: {x: -100 m, y: 0 m, z: -55 m}}", "{motion: {amplitude: {x: 1 m}, period: 9 s}}",
       "lines[0].ends[0]", "none of fixed"},
      {"two places", "{bed: {x: 50 m, y: 10 m}}", "{bed: {x: 50 m, y: 10 m}, water: {x: 0 m, y: 0 m, z: -1 m}}",
       "lines[1].ends[0]", "bed and water"},
      {"body without vessel", "{bed: {x: 50 m, y: 10 m}}", "{body: vessel, at: {x: 0 m, y: 0 m, z: 0 m}}", "vessel",
       "missing"},
      {"in the air", "z: -20 m", "z: 20 m", "lines[1].ends[1].water.z", "use fixed"},
      {"under the bed", "z: -55 m", "z: -155 m", "lines[0].ends[0].fixed.z", "above the seabed"},
      {"no length", "{length: 120 m, ", "{", "lines[1].segments[0].length", "missing"},
      {"one end", "[{bed: {x: 50 m, y: 10 m}}, {water: {x: 0 m, y: 10 m, z: -20 m}, direction: {z: 1}}]",
       "[{bed: {x: 50 m, y: 10 m}}]", "lines[1].ends", "exactly 2"},
      {"no direction", "direction: {z: 1}", "direction: {z: 0}", "lines[1].ends[1].direction", "no length"},
      {"mass and weight", "mass: 165 kg/m", "mass: 165 kg/m, weight_in_air: 1 kN/m", "lines[0].segments[0].mass",
       "one of them"},
  };
  for (const ModelSlip& slip : slips) expect_reported(kLines, slip);
}

TEST(moorings, programs_of_winches_are_read_and_looked_at) {
  const std::string main = "main: {speed: 0.2 m/s, haul: 700 kN, stall: 900 kN, brake: 1600 kN, drum: 1500 m}";
  const auto with = [&](const std::string& keys) { return replaced(kMoored, main, "main: {" + keys + "}"); };
  const Description d = read_good(
      with("mode: speed, speed: 0.1 m/s, acceleration_time: 5 s, program: [{time: 60 s, paid_out: 5 m}, {time: 300 s, "
           "paid_out: -1 m}]"));
  const WinchDescription& winch = d.moorings.value().winches.at(0);
  EXPECT_EQ(winch.mode, WinchMode::speed);
  EXPECT_EQ(winch.acceleration_time, 5.0);
  ASSERT_EQ(winch.program.size(), 2u);
  EXPECT_EQ(winch.program[1].time, 300.0);
  EXPECT_EQ(winch.program[1].paid_out, -1.0);
  EXPECT_EQ(read_good(with("mode: tension, tension: 300 kN, band: 20 kN")).moorings.value().winches.at(0).band, 20e3);
  const auto rejected = [&](const std::string& keys) {
    return !read_model_text(with(keys), std::string(OVERBEND_SOURCE_DIR) + "/examples/bad.yaml")
                .diagnostics.lines(Severity::error)
                .empty();
  };
  EXPECT_TRUE(rejected("mode: speed"));
  EXPECT_TRUE(rejected("program: [{time: 60 s, paid_out: 5 m}]"));  // a winch that holds
  EXPECT_TRUE(rejected("mode: length, program: [{time: 60 s, paid_out: 5 m}, {time: 60 s, paid_out: 6 m}]"));
  EXPECT_TRUE(rejected("mode: length, program: [{time: 60 s}]"));
}

TEST(moorings, a_pose_to_be_found_of_a_vessel_that_is_held_is_warned_of) {
  const auto warned = [](const std::string& text) {
    const ModelReading reading = read_model_text(text, std::string(OVERBEND_SOURCE_DIR) + "/examples/m.yaml");
    for (const std::string& line : reading.diagnostics.lines(Severity::error)) ADD_FAILURE() << line;
    const std::vector<std::string> lines = reading.diagnostics.lines(Severity::warning);
    return std::any_of(lines.begin(), lines.end(), [](const std::string& line) {
      return line.find("moorings.find: no pose is found: the vessel is held as drawn") != std::string::npos;
    });
  };
  const std::string pose = replaced(kMoored, "moorings:\n", "moorings:\n  find: pose\n");
  EXPECT_FALSE(warned(pose));
  std::string held = replaced(pose, "  hydrostatics: {heave: 36198.9 kN/m, roll: 2075448 kN*m, pitch: 42799210 kN*m}\n",
                              "  motion: {harmonic: {heave: {amplitude: 1 m, period: 8 s}}}\n");
  held = replaced(held, "  loads:\n    - {name: pipe, at: {x: -60 m}, force: {x: -205.6 kN}}\n", "");
  held = replaced(held, ", loads: [{moment: {z: 8000 kN*m}}]", "");
  held = replaced(held, ", loads: []", "");
  EXPECT_TRUE(warned(held));
  EXPECT_FALSE(warned(replaced(held, "  find: pose\n", "")));
}

}  // namespace
}  // namespace overbend
