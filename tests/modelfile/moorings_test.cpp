// Models of moorings, lines and floating hulls, without a pipe.
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <functional>
#include <numbers>
#include <sstream>

#include "base/constants.h"
#include "base/yaml_document.h"
#include "model/line_types.h"
#include "model/model.h"
#include "modelfile/model_texts.h"
#include "modelfile/moored_texts.h"
#include "modelfile/yaml_edit.h"
#include "modelfile/yaml_reader.h"

namespace overbend {
namespace {

using testing::kLines;
using testing::kMoored;

Description read_good(const std::string& text) {
  const ModelReading reading = read_model_text(text, std::string(OVERBEND_SOURCE_DIR) + "/examples/good.yaml");
  for (const std::string& line : reading.diagnostics.lines(Severity::error)) ADD_FAILURE() << line;
  return reading.description.value_or(Description{});
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return at == std::string::npos ? text : text.replace(at, from.size(), to);
}

TEST(moorings, a_vessel_on_lines_needs_no_pipe) {
  const Description d = read_good(kMoored);
  EXPECT_FALSE(d.has_pipe);
  EXPECT_TRUE(read_good(testing::kGoodModel).has_pipe);
  const Model model = build_model(d);
  EXPECT_TRUE(model.sections.empty());
}

TEST(moorings, what_was_assumed_of_lines_is_said) {
  const std::vector<std::string> list = assumptions(build_model(read_good(kMoored)));
  const auto says = [&](const std::string& words) {
    return std::any_of(list.begin(), list.end(),
                       [&](const std::string& s) { return s.find(words) != std::string::npos; });
  };
  EXPECT_TRUE(says("'wire64' is a six-strand wire rope of 64 mm with a wire core: 16.34 kg/m, EA 165.5 MN"));
  EXPECT_TRUE(says("'chain76' is a studless chain R4 of 76 mm"));
  EXPECT_FALSE(says("'given'"));
  EXPECT_TRUE(says("fixed point of the vessel"));
  EXPECT_FALSE(says("stern shoe"));
  for (const std::string& line : assumptions(build_model(read_good(kLines)))) {
    EXPECT_EQ(line.find("vessel"), std::string::npos) << line;
  }
}

TEST(moorings, a_vessel_whose_motion_is_told_moves_ahead_without_them) {
  const std::string told = testing::kGoodModel;
  const Description d = read_good(told + "\noperation: {type: pull_ahead, distance: 12.2 m}\n");
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
    EXPECT_TRUE(reading.description->warnings.empty()) << reading.description->warnings.front();
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
    Diagnostics faults;
    std::vector<YamlChange> values;
    collect(*parse_yaml(text, "", faults), "", values);
    EXPECT_GT(values.size(), 20U);
    for (const YamlChange& value : values) EXPECT_EQ(edit_yaml(text, {value}), text) << value.path;
  }
}

struct Slip {
  const char* claim;
  std::string find, replace;
  std::string key, words;
};

void expect_told(const std::string& good, const Slip& slip) {
  SCOPED_TRACE(slip.claim);
  const ModelReading reading = read_model_text(replaced(good, slip.find, slip.replace), "slip.yaml");
  EXPECT_FALSE(reading.description);
  const std::vector<Diagnostic> all = reading.diagnostics.sorted();
  const bool told = std::any_of(all.begin(), all.end(), [&](const Diagnostic& d) {
    return d.severity == Severity::error && d.key == slip.key && d.line > 0 &&
           render(d).find(slip.words) != std::string::npos;
  });
  EXPECT_TRUE(told) << (all.empty() ? "nothing was said" : render(all.front()));
  EXPECT_EQ(reading.diagnostics.error_count(), 1);
}

TEST(moorings, every_slip_is_told_once_with_key_and_remedy) {
  const std::string stern = "anchor: {x: -1050 m, y: 20 m}";
  const std::vector<Slip> slips = {
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
       "only the first"},
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
      {"two of a name", "name: starboard bow", "name: port bow", "moorings.lines[1].name", "already in line"},
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
  for (const Slip& slip : slips) expect_told(kMoored, slip);
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
  expect_told(replaced(two, "    chain76: {chain: {diameter: 76 mm}, friction: 0.8}\n", ""),
              {"two lines", "draught: 5 m", "draught: 4 m", "moorings.lines", "at least three"});
}

TEST(moorings, loads_on_a_held_hull_are_refused) {
  const std::size_t from = kMoored.find("  hydrostatics:"), to = kMoored.find("  loads:");
  expect_told(kMoored.substr(0, from) + kMoored.substr(to),
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

TEST(lines, every_slip_is_told_once_with_key_and_remedy) {
  const std::vector<Slip> slips = {
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
  for (const Slip& slip : slips) expect_told(kLines, slip);
}

/// The interface of a coupled hull, with files of the repository.
const std::string kCoupled = R"(overbend: 1
environment:
  water_depth: 89 m
  seabed: {stiffness: 100 kN/m^2}
  current: [{depth: 0 m, speed: 1 m/s, towards: 0 deg}]
vessel:
  depth: 9 m
  draught: 5.182 m
  motion:
    coupled:
      hydrodynamics: ../data/bgl1/bgl1
      mass: 19121.58 t
      centre_of_gravity: {x: 0 m, y: 0 m, z: 0.818 m}
      gyration: {roll: 10.5 m, pitch: 30 m, yaw: 30 m}
      wave_drift: mean
      damping: {roll: 5 %, sway: {linear: 100 kN*s/m, quadratic: 10 kN*s^2/m^2}}
      current: {transverse: 0.9}
      wind: {speed: 10 m/s, from: 90 deg, areas: [{name: deckhouse, area: 200 m^2, centre: {x: -30 m, y: 0 m, z: 10 m}, frontal: yes}]}
station_keeping:
  dp:
    surge: {stiffness: 100 kN/m, damping: 10 kN*s/m, thrust_limit: 500 kN}
    yaw: {stiffness: 1e6 kN*m}
)";

TEST(coupled_hull, keys_fill_the_description) {
  const Description d = read_good(kCoupled);
  EXPECT_FALSE(d.has_pipe);
  EXPECT_EQ(d.vessel.motion, VesselMotion::coupled);
  ASSERT_TRUE(d.vessel.coupled);
  const CoupledHullDescription& hull = *d.vessel.coupled;
  EXPECT_NEAR(hull.mass, 19121.58e3, 1e-6);
  EXPECT_EQ(hull.gyration, Vec3(10.5, 30.0, 30.0));
  EXPECT_EQ(hull.wave_drift, WaveDrift::mean);
  ASSERT_EQ(hull.damping.size(), 2U);  // in the order of the degrees of freedom
  EXPECT_EQ(hull.damping[0].mode, "sway");
  EXPECT_NEAR(hull.damping[0].linear.value(), 1e5, 1e-9);
  EXPECT_EQ(hull.damping[1].mode, "roll");
  EXPECT_NEAR(hull.damping[1].ratio.value(), 0.05, 1e-15);
  EXPECT_EQ(hull.current.transverse, 0.9);
  EXPECT_TRUE(hull.current.stated);
  EXPECT_TRUE(hull.wind.areas.at(0).frontal);
  ASSERT_TRUE(d.station_keeping);
  EXPECT_EQ(d.station_keeping->stiffness, Vec3(1e5, 0.0, 1e9));
  EXPECT_EQ(d.station_keeping->limit.x(), 5e5);
}

TEST(coupled_hull, its_files_are_read_with_their_conventions) {
  const std::string found = "hydrodynamics: ../data/bgl1/bgl1\n";
  const Description d = read_good(replaced(kCoupled, found, found + "      convention: {drift_from: 0.5 rad/s}\n"));
  ASSERT_TRUE(d.vessel.coupled && d.vessel.coupled->data);
  const HydrodynamicData& data = *d.vessel.coupled->data;
  EXPECT_EQ(data.origin_V, Vec3(0.0, 0.0, 0.818));
  EXPECT_NEAR(data.hydrostatic_stiffness(2, 2), 1025.0 * 9.81 * 3600.0, 1e3);  // a box of 120 x 30 m
  EXPECT_EQ(data.excitation.heading.size(), 24U);
  EXPECT_EQ(data.mean_drift.at(data.drift.index(0, 6))[1], 0.0);
}

TEST(coupled_hull, files_of_another_hull_or_scale_are_refused) {
  const std::string stem = std::string(OVERBEND_SOURCE_DIR) + "/data/bgl1/bgl1";
  const std::string good = replaced(kCoupled, "../data/bgl1/bgl1", stem);
  const std::string key = "vessel.motion.coupled.hydrodynamics";
  expect_told(good,
              {"length scale", stem + "\n", stem + "\n      convention: {length_scale: 10 m}\n", key, "waterplane"});
  expect_told(good, {"another vessel", "  depth: 9 m", "  length: 500 m\n  depth: 9 m", key, "3600 m^2"});
}

/// Files of BGL-1 under a stem of their own, with the lines of one of them that are wanted.
std::string thinned_files(const std::string& ending, const std::function<bool(std::istringstream&)>& wanted) {
  const std::string from = std::string(OVERBEND_SOURCE_DIR) + "/data/bgl1/bgl1";
  const std::string stem = ::testing::TempDir() + "thinned" + ending.substr(1);
  for (const char* each : {".1", ".3", ".8", ".hst"}) {
    std::ifstream in(from + each);
    std::ofstream out(stem + each);
    for (std::string line; std::getline(in, line);) {
      std::istringstream numbers(line);
      if (each != ending || wanted(numbers)) out << line << '\n';
    }
  }
  return stem;
}

TEST(coupled_hull, drift_of_one_side_of_the_hull_alone_is_refused_as_forces_are) {
  const std::string stem = thinned_files(".8", [](std::istringstream& line) {
    double period = 0.0, heading = 0.0;
    line >> period >> heading;
    return heading <= 180.0;
  });
  const std::string calm = "  current: [{depth: 0 m, speed: 1 m/s, towards: 0 deg}]\n";
  const std::string waves = calm + "  waves: {type: airy, height: 1 m, period: 8 s, from: 300 deg}\n";
  const std::string good = replaced(kCoupled, calm, waves);
  expect_told(good,
              {"half", "../data/bgl1/bgl1", stem, "vessel.motion.coupled.hydrodynamics", "headings of the drift"});
  const std::string mirrored = "hydrodynamics: " + stem + "\n      convention: {headings: mirrored}";
  EXPECT_TRUE(read_model_text(replaced(good, "hydrodynamics: ../data/bgl1/bgl1", mirrored), "m.yaml").description);
}

TEST(coupled_hull, files_without_a_mode_are_warned_of) {
  const std::string stem = thinned_files(".1", [](std::istringstream& line) {
    double period = 0.0;
    int i = 0, j = 0;
    line >> period >> i >> j;
    return i != 3 && j != 3;
  });
  const ModelReading reading = read_model_text(replaced(kCoupled, "../data/bgl1/bgl1", stem), "m.yaml");
  ASSERT_TRUE(reading.description);
  const std::vector<std::string> warnings = reading.diagnostics.lines(Severity::warning);
  EXPECT_TRUE(std::any_of(warnings.begin(), warnings.end(), [](const std::string& line) {
    return line.find("no added mass of heave") != std::string::npos;
  }));
}

TEST(coupled_hull, current_may_be_left_out_only_in_words) {
  const Description d = read_good(replaced(kCoupled, "current: {transverse: 0.9}", "current: none"));
  EXPECT_EQ(d.vessel.coupled->current.form, HullCurrentForm::none);
}

TEST(coupled_hull, current_may_act_by_the_coefficients_of_the_hulls_dimensions) {
  const Description d = read_good(replaced(kCoupled, "{transverse: 0.9}", "{form: ufc, relative_to: earth}"));
  EXPECT_EQ(d.vessel.coupled->current.form, HullCurrentForm::ufc);
  EXPECT_EQ(d.vessel.coupled->current.relative_to, CurrentRelativeTo::earth);
}

TEST(coupled_hull, wind_may_act_by_a_table) {
  const std::string file = ::testing::TempDir() + "wind_table.csv";
  std::ofstream(file) << "angle_deg,cx,cy,cz\n0,0.7,0,0\n60,0.4,0.6,0.05\n120,-0.4,0.6,-0.05\n180,-0.7,0,0\n";
  const std::string areas =
      "areas: [{name: deckhouse, area: 200 m^2, centre: {x: -30 m, y: 0 m, z: 10 m}, frontal: yes}]";
  const std::string table = "table: " + file + ", axes: to_from_bow, frontal_area: 115 m^2, lateral_area: 460 m^2";
  const WindDescription wind = read_good(replaced(kCoupled, areas, table)).vessel.coupled->wind;
  EXPECT_EQ(wind.table.size(), 6U);  // the other side is mirrored
  EXPECT_EQ(wind.frontal_area.value(), 115.0);
  EXPECT_EQ(wind.axes.value(), CoefficientAxes::to_from_bow);
}

TEST(coupled_hull, mean_drift_acts_in_statics_as_asked_for) {
  EXPECT_FALSE(read_good(kCoupled).statics.mean_drift);
  EXPECT_TRUE(read_good(kCoupled + "analysis: {static: {mean_drift: yes}}\n").statics.mean_drift.value());
  EXPECT_FALSE(read_good(kCoupled + "analysis: {static: {mean_drift: no}}\n").statics.mean_drift.value());
}

TEST(coupled_hull, every_slip_is_told_once_with_key_and_remedy) {
  const std::string c = "vessel.motion.coupled.";
  const std::string stem = std::string(OVERBEND_SOURCE_DIR) + "/data/bgl1/bgl1";
  const std::string good = replaced(kCoupled, "../data/bgl1/bgl1", stem);
  const std::vector<Slip> slips = {
      {"a current on no hull", "      current: {transverse: 0.9}\n", "", c + "current", "strips, a table, or none"},
      {"no files", stem + "\n", stem + "x\n", c + "hydrodynamics", "there is no file"},
      {"mass in kg", "19121.58 t", "1.912158e10 kg", c + "mass", "displaced by a box"},
      {"damping twice", "{linear: 100 kN*s/m,", "{ratio: 1 %, linear: 100 kN*s/m,", c + "damping.sway.linear",
       "one of them"},
      {"damping of another dimension", "linear: 100 kN*s/m", "linear: 100 kN*m*s", c + "damping.sway.linear", "kN*s/m"},
      {"areas without a table", "{transverse: 0.9}", "{lateral_area: 600 m^2}", c + "current.lateral_area",
       "the key table"},
      {"coefficients twice", "{transverse: 0.9}", "{form: ufc, transverse: 0.9}", c + "current.transverse",
       "one of them"},
      {"wind on nothing",
       ", areas: [{name: deckhouse, area: 200 m^2, centre: {x: -30 m, y: 0 m, z: 10 m}, frontal: yes}]", "",
       c + "wind.areas", "acts on nothing"},
  };
  for (const Slip& slip : slips) expect_told(good, slip);
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
  const auto refused = [&](const std::string& keys) {
    return !read_model_text(with(keys), std::string(OVERBEND_SOURCE_DIR) + "/examples/bad.yaml")
                .diagnostics.lines(Severity::error)
                .empty();
  };
  EXPECT_TRUE(refused("mode: speed"));
  EXPECT_TRUE(refused("program: [{time: 60 s, paid_out: 5 m}]"));  // a winch that holds
  EXPECT_TRUE(refused("mode: length, program: [{time: 60 s, paid_out: 5 m}, {time: 60 s, paid_out: 6 m}]"));
  EXPECT_TRUE(refused("mode: length, program: [{time: 60 s}]"));
}

}  // namespace
}  // namespace overbend
