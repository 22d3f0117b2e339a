// The table of fields says what a number may be; the reader holds every key to it.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "base/yaml_document.h"
#include "modelfile/fields/field_table.h"
#include "modelfile/model_texts.h"
#include "modelfile/reading/yaml_reader.h"
#include "modelfile/schema/field_tree.h"

namespace overbend {
namespace {

bool is_number(const Field& field) {
  return field.kind == FieldKind::quantity || field.kind == FieldKind::number || field.kind == FieldKind::integer;
}

YamlNode make_node(YamlNode::Kind kind, const std::string& text = {}) {
  YamlNode node;
  node.kind = kind;
  node.text = text;
  node.line = 1;
  return node;
}

/// A key put into the good model, with the path that complaints name it by.
struct Placed {
  YamlNode* node;
  std::string path;
};

YamlNode& member(YamlNode& node, const std::string& key) {
  if (node.kind != YamlNode::Kind::map) node = make_node(YamlNode::Kind::map);
  for (YamlEntry& entry : node.entries) {
    if (entry.key == key) return entry.value;
  }
  node.entries.push_back({key, 1, 1, {}});
  return node.entries.back().value;
}

/// A node of a list of at least so many items.
YamlNode& first_item(YamlNode& node, int min_value) {
  if (node.kind != YamlNode::Kind::list) node = make_node(YamlNode::Kind::list);
  node.items.resize(std::max({node.items.size(), std::size_t{1}, static_cast<std::size_t>(min_value)}));
  return node.items.front();
}

/// "rollers.*.stiffness" in the model: any name is its roller "v", any item its first.
Placed place(YamlNode& root, const std::string& path) {
  Placed placed{&root, ""};
  for (std::size_t start = 0; start < path.size();) {
    const std::size_t dot = std::min(path.find('.', start), path.size());
    std::string key = path.substr(start, dot - start);
    const bool item = key.ends_with("[]");
    if (item) key.resize(key.size() - 2);
    if (key == "*") key = "v";
    placed.node = &member(*placed.node, key);
    placed.path += (placed.path.empty() ? "" : ".") + key;
    if (item) {
      placed.node = &first_item(*placed.node, field_node(path.substr(0, dot - 2)).list->min_items);
      placed.path += "[0]";
    }
    start = dot + 1;
  }
  return placed;
}

/// A number as a file has it, exact to the last bit.
std::string written(const Field& field, double value) {
  if (field.kind == FieldKind::integer && std::abs(value) < 1e16) return fmt::format("{:.0f}", value);
  if (field.kind != FieldKind::quantity) return fmt::format("{:.17g}", value);
  return field.unit == "1" ? fmt::format("{:.17g} %", 100.0 * value) : fmt::format("{:.17g} {}", value, field.unit);
}

/// Each edge, just below and just above it; zero, negative and huge.
std::vector<double> probes(const Field& field) {
  std::vector<double> values{0.0, 1.0, -1.0, -1e-9, -1e12, 1e300, -1e300};
  for (const double edge : {field.range.low, field.range.high}) {
    if (!std::isfinite(edge)) continue;
    const double near = field.kind == FieldKind::integer ? 1.0 : edge == 0.0 ? 1e-6 : 1e-9 * std::abs(edge);
    values.insert(values.end(), {edge - near, edge, edge + near});
  }
  if (field.kind == FieldKind::integer) std::erase_if(values, [](double v) { return v != std::round(v); });
  return values;
}

bool may_be(const Field& field, double value) {
  const double max_value = field.kind == FieldKind::integer ? 9e15 : 1e15;        // whole numbers are exact up to 2^53
  const double bound = std::isfinite(field.range.high) ? field.range.high : 0.0;  // map coordinates reach beyond
  const double limit = field.kind == FieldKind::quantity ? std::max(max_sensible_value(field.unit), bound) : max_value;
  return field.range.contains(value) && std::abs(value) <= limit;
}

bool has_error_for(const ModelReading& reading, const std::string& key) {
  const std::vector<Diagnostic> all = reading.diagnostics.sorted();
  return std::any_of(all.begin(), all.end(),
                     [&](const Diagnostic& d) { return d.severity == Severity::error && d.key == key; });
}

class field_ranges : public ::testing::Test {
 protected:
  void SetUp() override {
    Diagnostics diagnostics;
    std::optional<YamlNode> root = parse_yaml(testing::kGoodModel, "good.yaml", diagnostics);
    ASSERT_TRUE(root.has_value());
    good = std::move(*root);
  }

  /// Messages on the good model with `text` for the key; the key's full path in `path`.
  ModelReading read(const Field& field, const std::string& text, std::string& path) const {
    YamlNode root = good;
    const Placed placed = place(root, field.path);
    *placed.node = make_node(YamlNode::Kind::scalar, text);
    path = placed.path;
    return read_statics_inputs(root, "good.yaml");
  }

  YamlNode good;
};

TEST_F(field_ranges, every_numeric_key_is_held_to_its_edges) {
  for (const Field& field : field_table()) {
    if (!is_number(field)) continue;
    for (const double value : probes(field)) {
      const std::string text = written(field, value);
      SCOPED_TRACE(field.path + ": " + text);
      std::string path;
      ModelReading reading;
      ASSERT_NO_THROW(reading = read(field, text, path));
      if (!may_be(field, value)) {
        EXPECT_FALSE(reading.description.has_value());
        EXPECT_TRUE(has_error_for(reading, path));
      }
    }
  }
}

TEST_F(field_ranges, no_key_takes_what_is_not_a_number) {
  for (const Field& field : field_table()) {
    if (!is_number(field)) continue;
    const std::string unit = field.kind == FieldKind::quantity ? (field.unit == "1" ? " %" : " " + field.unit) : "";
    for (const char* word : {".nan", "nan", ".inf", "-.inf", "inf", "1e400"}) {
      SCOPED_TRACE(field.path + ": " + word);
      std::string path;
      ModelReading reading;
      ASSERT_NO_THROW(reading = read(field, word + unit, path));
      EXPECT_FALSE(reading.description.has_value());
      EXPECT_TRUE(has_error_for(reading, path));
    }
  }
}

TEST_F(field_ranges, what_lies_within_is_taken) {
  for (const auto& [key, text] : std::vector<std::pair<std::string, std::string>>{{"tensioner.incline", "90 deg"},
                                                                                  {"pipe.length", "2 km"},
                                                                                  {"rollers.*.stiffness", "1 MN/m"},
                                                                                  {"analysis.dynamic.build_up", "0 s"},
                                                                                  {"environment.seabed.slope", "0 deg"},
                                                                                  {"checks.alpha_u", "1"}}) {
    const auto row = std::find_if(field_table().begin(), field_table().end(),
                                  [&, k = key](const Field& f) { return f.path == k && is_number(f); });
    ASSERT_NE(row, field_table().end()) << key;
    std::string path;
    const ModelReading reading = read(*row, text, path);
    EXPECT_FALSE(has_error_for(reading, path)) << key;
  }
}

// Lengths, stiffnesses, strengths: a row without a lower bound would let nonsense through to the solver.
TEST_F(field_ranges, only_places_and_angles_may_be_negative) {
  const std::set<std::string> places = {"tensioner.x",
                                        "tensioner.z",
                                        "supports.ramp.boxes[].x",
                                        "supports.ramp.boxes[].z",
                                        "supports.stinger.boxes[].x",
                                        "supports.stinger.boxes[].z",
                                        "supports.ramp.boxes[].offset",
                                        "supports.stinger.boxes[].offset",
                                        "environment.seabed.profile[].x",
                                        "environment.seabed.profile[].depth",
                                        "operation.winch.depth",
                                        "environment.seabed.bathymetry_midship.east",
                                        "environment.seabed.bathymetry_origin.east",
                                        "environment.seabed.bathymetry_origin.north",
                                        "environment.seabed.bathymetry_midship.north",
                                        "route.points[].x",
                                        "route.points[].y",
                                        "supports.stinger.sections[].boxes[].offset",
                                        "vessel.stern_shoe.x",
                                        "vessel.stern_shoe.z"};
  const auto component = [](const std::string& path) {
    return path.ends_with(".x") || path.ends_with(".y") || path.ends_with(".z");
  };
  for (const Field& field : field_table()) {
    if (!is_number(field) || field.unit == "rad" || places.count(field.path) != 0) continue;
    if (field.path.find(".motion.convention.") != std::string::npos) continue;
    const bool vector =
        component(field.path) &&
        (field.path.find("moorings") == 0 || field.path.find("lines") == 0 || field.path.find("operation") == 0 ||
         field.path.find("vessel") == 0 || field.path.find("bodies[].place") == 0 ||
         field.path.find("supports.") == 0 || field.path.find("environment.waves") == 0);
    const bool floats = field.path.ends_with(".weight_submerged");  // a line that is lighter than water
    const bool direction = field.path == "operation.distance" || field.path.ends_with(".paid_out") ||
                           field.path.find(".release.") != std::string::npos;  // astern, hauled in, either way
    const bool strut = field.path.ends_with(".pretension");                    // that is pressed
    if (vector || floats || direction || strut) continue;
    const bool pressure = field.path.ends_with("contents.pressure");  // a vacuum at least
    EXPECT_GE(field.range.low, pressure ? -0.1e6 : 0.0) << field.path;
  }
}

TEST_F(field_ranges, what_has_to_be_above_zero_says_so) {
  for (const std::string key : {"environment.seabed.stiffness",
                                "environment.water_depth",
                                "pipe.steel.yield_stress",
                                "pipe.steel.youngs_modulus",
                                "pipe.steel.outside_diameter",
                                "pipe.steel.wall_thickness",
                                "pipe.length",
                                "pipe.anchor",
                                "pipe.segments[].length",
                                "pipe.coatings[].thickness",
                                "rollers.*.stiffness",
                                "rollers.*.bottom.radius",
                                "rollers.*.bottom.face",
                                "rollers.*.tangential_stiffness",
                                "tensioner.tension",
                                "tensioner.acceleration",
                                "analysis.dynamic.duration",
                                "analysis.dynamic.step",
                                "analysis.dynamic.max_step",
                                "analysis.dynamic.output_step",
                                "analysis.dynamic.impact_force",
                                "vessel.motion.harmonic.heave.period"}) {
    const auto row = std::find_if(field_table().begin(), field_table().end(),
                                  [&](const Field& f) { return f.path == key && is_number(f); });
    ASSERT_NE(row, field_table().end()) << key;
    EXPECT_FALSE(row->range.contains(0.0)) << key;
  }
}

}  // namespace
}  // namespace overbend
