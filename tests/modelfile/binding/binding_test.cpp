// Content of a file in the members of the description.
#include "modelfile/binding/binding.h"

#include <gtest/gtest.h>

#include <cmath>

#include "model/description/description_enum_names.h"
#include "model/pipe/contact_stiffness.h"
#include "modelfile/fields/field_table.h"
#include "modelfile/model_texts.h"
#include "modelfile/reading/yaml_reader.h"
#include "modelfile/schema/scalar_reader.h"

namespace overbend {
namespace {

using testing::kGoodModel;

Description read_good(const std::string& text) {
  const ModelReading reading = read_model_text(text, "folder/good.yaml");
  for (const std::string& line : reading.diagnostics.lines(Severity::error)) ADD_FAILURE() << line;
  return reading.description.value_or(Description{});
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const std::size_t index = text.find(from);
  EXPECT_NE(index, std::string::npos) << from;
  return text.replace(index, from.size(), to);
}

YamlNode scalar(const std::string& text) {
  YamlNode node;
  node.kind = YamlNode::Kind::scalar;
  node.text = text;
  node.line = 1;
  return node;
}

// The number of the documentation and the number of the computation are one: written with few digits, read by the same
// reader, it comes back to rounding.
TEST(binding, a_default_as_the_reference_shows_it_is_that_of_the_member) {
  int defaults = 0;
  for (const Field& row : field_table()) {
    if (!row.member.standard) {
      EXPECT_TRUE(row.fallback.empty()) << row.path;
      continue;
    }
    SCOPED_TRACE(row.path + ": " + row.fallback);
    const ScalarReading reading = read_scalar(scalar(row.fallback), row);
    ASSERT_TRUE(reading.value.has_value());
    EXPECT_TRUE(reading.unusual.empty());
    if (const auto* number = std::get_if<double>(&*row.member.standard)) {
      EXPECT_NEAR(reading.value->number, *number, 1e-15 * std::abs(*number));
    } else if (const auto* integer = std::get_if<std::int64_t>(&*row.member.standard)) {
      EXPECT_EQ(reading.value->integer, *integer);
    } else {
      EXPECT_EQ(reading.value->text, std::get<std::string>(*row.member.standard));
    }
    ++defaults;
  }
  EXPECT_GT(defaults, 60);
}

TEST(binding, the_default_stiffness_of_a_roller_is_the_one_that_the_model_takes) {
  const Field& row = *field_node("rollers.*.structure_stiffness").scalar;
  EXPECT_EQ(std::get<double>(row.member.standard.value()), kRollerStructure);
}

TEST(binding, a_choice_has_the_names_of_its_enumeration) {
  EXPECT_EQ(field_node("environment.waves.type").scalar->choices, enum_names<WaveType>());
  EXPECT_EQ(field_node("checks.manufacture").scalar->choices, enum_names<Manufacture>());
  EXPECT_EQ(field_node("checks.point_load").scalar->choices, (std::vector<std::string>{"no", "yes"}));
  // The other motions are keys, not words.
  EXPECT_EQ(field_node("vessel.motion").scalar->choices, (std::vector<std::string>{"fixed"}));
}

TEST(binding, every_word_of_every_choice_is_taken) {
  for (const Field& row : field_table()) {
    if (row.kind != FieldKind::choice || row.path.find_first_of("*[") != std::string::npos) continue;
    for (const std::string& word : row.choices) {
      FieldValue value;
      value.kind = FieldValue::Kind::text;
      value.text = word;
      FieldValue group;
      const std::size_t dot = row.path.find_last_of('.');
      value.key = row.path.substr(dot + 1);
      group.children.push_back(value);
      // Up to the root, through the groups of the path.
      for (std::string path = row.path.substr(0, dot);; path.erase(path.find_last_of('.'))) {
        FieldValue outer;
        group.key = path.substr(path.find_last_of('.') + 1);
        outer.children.push_back(group);
        group = outer;
        if (path.find('.') == std::string::npos) break;
      }
      EXPECT_NO_THROW(bind_model(group, "good.yaml")) << row.path << ": " << word;
    }
  }
}

TEST(binding, a_row_under_the_wrong_group_is_a_broken_promise) {
  SteelDescription steel;
  Target target = &steel;
  EXPECT_EQ(&object<SteelDescription>(target), &steel);
  EXPECT_THROW(object<WavesDescription>(target), std::logic_error);
}

TEST(binding, files_are_found_next_to_the_model_file) {
  EXPECT_EQ(resolved_file("rao.csv", "folder/good.yaml"), "folder/rao.csv");
  EXPECT_EQ(resolved_file("../rao.csv", "folder/good.yaml"), "rao.csv");
  EXPECT_EQ(resolved_file("/data/rao.csv", "folder/good.yaml"), "/data/rao.csv");
  for (const char* path : {"vessel.motion.raos", "vessel.motion.history", "vessel.motion.coupled.hydrodynamics",
                           "vessel.motion.coupled.current.table", "environment.waves.spectrum_file"}) {
    EXPECT_TRUE(field_node(path).scalar->file) << path;
  }
}

/// The good model with a line that yields, and a segment with the keys given.
std::string with_segment(const std::string& keys) {
  const std::string material = "    material: {law: ramberg_osgood, hardening_exponent: 20}\n";
  const std::string text = replaced(kGoodModel, "    yield_stress:", material + "    yield_stress:");
  return replaced(text, ", steel: {wall_thickness: 20 mm}}", keys + "}");
}

// It was taken for linear steel.
TEST(binding, a_segment_that_says_nothing_of_its_steel_yields_as_the_line_does) {
  const Description d = read_good(with_segment(""));
  ASSERT_EQ(d.pipe.segments.size(), 1U);
  const MaterialDescription& material_description = d.pipe.segments[0].section.steel.material;
  EXPECT_EQ(material_description.law, MaterialLaw::ramberg_osgood);
  EXPECT_EQ(material_description.hardening_exponent, 20.0);
}

TEST(binding, a_segment_changes_only_what_it_gives) {
  const Description d = read_good(with_segment(", steel: {wall_thickness: 25 mm, material: {law: linear}}"));
  ASSERT_EQ(d.pipe.segments.size(), 1U);
  const SectionDescription& section_description = d.pipe.segments[0].section;
  EXPECT_DOUBLE_EQ(section_description.steel.wall_thickness, 0.025);
  EXPECT_EQ(section_description.steel.material.law, MaterialLaw::linear);
  EXPECT_EQ(section_description.steel.outside_diameter, d.pipe.section.steel.outside_diameter);
  EXPECT_EQ(section_description.coatings.size(), d.pipe.section.coatings.size());
  EXPECT_EQ(section_description.hydrodynamics.drag_normal, d.pipe.section.hydrodynamics.drag_normal);
  EXPECT_EQ(d.pipe.section.steel.material.law, MaterialLaw::ramberg_osgood);
}

TEST(binding, a_segment_may_take_the_exponent_of_its_law_from_the_line) {
  const Description d = read_good(with_segment(", steel: {material: {law: moment_ramberg_osgood}}"));
  ASSERT_EQ(d.pipe.segments.size(), 1U);
  EXPECT_EQ(d.pipe.segments[0].section.steel.material.law, MaterialLaw::moment_ramberg_osgood);
  EXPECT_EQ(d.pipe.segments[0].section.steel.material.hardening_exponent, 20.0);
}

TEST(binding, coatings_of_a_segment_replace_those_of_the_line) {
  const Description d = read_good(with_segment(", coatings: [{thickness: 3 mm, weight_density: 9 kN/m^3}]"));
  ASSERT_EQ(d.pipe.segments.size(), 1U);
  ASSERT_EQ(d.pipe.segments[0].section.coatings.size(), 1U);
  EXPECT_EQ(d.pipe.segments[0].section.coatings[0].name, "coating 1");
}

/// A model with its groups in an order that no one would write.
constexpr const char* kUpsideDown = R"(supports:
  stinger:
    boxes: [{x: 10 m, z: -1 m, length: 2 m}, {x: 20 m, z: -4 m, roller: other, rows: 3, length: 2 m}]
    rows: 2
    roller: kind
tensioner: {mode: locked, range: [500 kN, 600 kN], tension: 560 kN, z: 3 m, x: -60 m}
rollers:
  other: {bottom: {radius: 0.2 m, face: 1 m}}
  kind: {friction: {lateral: 0.2}, bottom: {radius: 0.15 m, face: 1 m}}
vessel: {stern_shoe: {z: 0 m, x: -60 m}}
pipe:
  segments: [{length: 50 m}]
  steel: {yield_stress: 414 MPa, wall_thickness: 0.0206 m, outside_diameter: 0.3239 m}
environment: {seabed: {friction: 0.3, stiffness: 150 kN/m^2}, water_depth: 400 m}
overbend: 1
)";

TEST(binding, the_order_of_the_keys_in_the_file_means_nothing) {
  const ModelReading reading = read_model_text(kUpsideDown, "good.yaml");
  ASSERT_TRUE(reading.description.has_value());
  const Description& d = *reading.description;
  ASSERT_EQ(d.supports.boxes.size(), 2U);
  EXPECT_EQ(d.supports.boxes[0].roller, "kind");
  EXPECT_EQ(d.supports.boxes[0].rows, 2);
  EXPECT_EQ(d.supports.boxes[0].name, "stinger 1");
  EXPECT_EQ(d.supports.boxes[1].roller, "other");
  EXPECT_EQ(d.supports.boxes[1].rows, 3);
  EXPECT_EQ(d.tensioner.mode, TensionerMode::locked);
  ASSERT_EQ(d.pipe.segments.size(), 1U);
  EXPECT_EQ(d.pipe.segments[0].section.steel.outside_diameter, d.pipe.section.steel.outside_diameter);
  EXPECT_EQ(d.environment.seabed.friction_axial, 0.3);
  EXPECT_EQ(d.environment.seabed.friction_lateral, 0.3);
  ASSERT_EQ(d.rollers.size(), 2U);
  EXPECT_EQ(d.rollers[1].friction_axial, 0.0);
  EXPECT_EQ(d.rollers[1].friction_lateral, 0.2);
}

}  // namespace
}  // namespace overbend
