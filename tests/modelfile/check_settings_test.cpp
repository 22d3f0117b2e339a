// The section `checks` of the model file.
#include <gtest/gtest.h>

#include <algorithm>

#include "modelfile/model_texts.h"
#include "modelfile/reading/yaml_reader.h"

namespace overbend {
namespace {

ModelReading read_with(const std::string& section) {
  return read_model_text(testing::kGoodModel + "\n" + section, "good.yaml");
}

std::string first_error(const std::string& section) {
  const std::vector<std::string> lines = read_with(section).diagnostics.lines(Severity::error);
  return lines.empty() ? "" : lines.front();
}

TEST(check_settings, without_the_section_the_defaults_stand) {
  const CheckSettings checks = read_with("").description.value().checks;
  EXPECT_EQ(checks.codes, CheckCodes::both);
  EXPECT_EQ(checks.safety_class, SafetyClass::low);
  EXPECT_FALSE(checks.manufacture);
  EXPECT_EQ(checks.alpha_u, 0.96);
  EXPECT_EQ(checks.ovality, 0.005);
  EXPECT_EQ(checks.api.edition, ApiEdition::fifth);
  // On the safe side.
  EXPECT_TRUE(checks.system_effects);
  EXPECT_EQ(checks.yield_basis, YieldBasis::fy);
  EXPECT_EQ(checks.current_load, CurrentLoad::environmental);
  EXPECT_FALSE(checks.limits.roller_load);
}

TEST(check_settings, every_key_arrives) {
  const CheckSettings checks = read_with(R"(checks:
  codes: dnv
  safety_class: high
  manufacture: hfw
  alpha_u: 1.0
  alpha_fab: 0.9
  wall_tolerance: 0.5 mm
  ovality: 0.01
  alpha_h: 0.9
  grade: X65
  condition_factor: 1.07
  system_effects: "no"
  yield_basis: smys
  current_load: functional
  point_load: yes
  arrestor: {propagation_pressure: 8 MPa, length: 0.5 m}
  api: {edition: third, collapse_factor: 0.65, bending_factor: 2, ovality: 0.003}
  yield_share: {overbend_static: 0.85, overbend_dynamic: 0.96, sagbend_static: 0.72, sagbend_dynamic: 0.87}
  limits: {roller_load: 120 kN, coating_line_load: 300 kN/m, tension: 400 kN, tip_clearance: 0.3 m}
)")
                                   .description.value()
                                   .checks;
  EXPECT_EQ(checks.codes, CheckCodes::dnv);
  EXPECT_EQ(checks.safety_class, SafetyClass::high);
  EXPECT_EQ(checks.manufacture, Manufacture::hfw);
  EXPECT_EQ(checks.alpha_u, 1.0);
  EXPECT_EQ(checks.alpha_fab, 0.9);
  EXPECT_DOUBLE_EQ(checks.wall_tolerance, 0.0005);
  EXPECT_EQ(checks.ovality, 0.01);
  EXPECT_EQ(checks.alpha_h, 0.9);
  EXPECT_EQ(checks.grade, "X65");
  EXPECT_EQ(checks.condition_factor, 1.07);
  EXPECT_FALSE(checks.system_effects);
  EXPECT_EQ(checks.yield_basis, YieldBasis::smys);
  EXPECT_EQ(checks.current_load, CurrentLoad::functional);
  EXPECT_TRUE(checks.point_load);
  EXPECT_DOUBLE_EQ(checks.arrestor.value().propagation_pressure, 8e6);
  EXPECT_DOUBLE_EQ(checks.arrestor->length, 0.5);
  EXPECT_EQ(checks.api.edition, ApiEdition::third);
  EXPECT_EQ(checks.api.collapse_factor, 0.65);
  EXPECT_EQ(checks.api.bending_factor, 2.0);
  EXPECT_EQ(checks.api.ovality, 0.003);
  EXPECT_EQ(checks.allowable_stress.overbend_static, 0.85);
  EXPECT_EQ(checks.allowable_stress.overbend_dynamic, 0.96);
  EXPECT_EQ(checks.allowable_stress.sagbend_static, 0.72);
  EXPECT_EQ(checks.allowable_stress.sagbend_dynamic, 0.87);
  EXPECT_DOUBLE_EQ(checks.limits.roller_load.value(), 120e3);
  EXPECT_DOUBLE_EQ(checks.limits.coating_line_load.value(), 300e3);
  EXPECT_DOUBLE_EQ(checks.limits.tension.value(), 400e3);
  EXPECT_DOUBLE_EQ(checks.limits.tip_clearance.value(), 0.3);
}

TEST(check_settings, what_can_not_be_is_rejected_with_its_key) {
  EXPECT_NE(first_error("checks: {wall_tolerance: 12 mm}\n").find("checks.wall_tolerance"), std::string::npos);
  EXPECT_NE(first_error("checks: {ovality: 0.001}\n").find("checks.ovality"), std::string::npos);
  EXPECT_NE(first_error("checks: {manufacture: forged}\n").find("checks.manufacture"), std::string::npos);
  EXPECT_NE(first_error("checks: {safty_class: low}\n").find("safety_class"), std::string::npos);
  EXPECT_NE(first_error("checks: {arrestor: {length: 1 m}}\n").find("propagation_pressure"), std::string::npos);
}

TEST(check_settings, the_strain_factor_of_field_joints_arrives) {
  const std::string text = testing::kGoodModel;
  const std::string joint = "infill_weight_density: 10.065 kN/m^3}";
  const std::string with = std::string(text).replace(text.find(joint), joint.size(),
                                                     "infill_weight_density: 10.065 kN/m^3, strain_factor: 1.3}");
  EXPECT_EQ(read_model_text(with, "good.yaml").description.value().pipe.section.joint->strain_factor, 1.3);
}

TEST(check_settings, limits_of_stronger_steel_than_the_pipes_are_warned_of) {
  const auto warned = [](const std::string& grade) {
    const ModelReading reading = read_with("checks: {grade: " + grade + "}\n");
    const std::vector<std::string> warnings = reading.diagnostics.lines(Severity::warning);
    return std::ranges::any_of(warnings, [](const std::string& line) {
      return line.find("checks.grade") != std::string::npos &&
             line.find("does not withstand its strains") != std::string::npos;
    });
  };
  EXPECT_FALSE(warned("X60"));  // the pipe's own, 414 MPa
  EXPECT_FALSE(warned("X52"));
  EXPECT_TRUE(warned("X70"));
}

TEST(check_settings, a_moment_curvature_curve_is_that_of_the_same_pipe_in_other_units) {
  std::string text = testing::kGoodModel;
  const std::string yield = "    yield_stress: 414 MPa\n", wall = "steel: {wall_thickness: 20 mm}";
  text.replace(text.find(yield), yield.size(),
               yield +
                   "    material: {law: moment_curvature, moment_curvature: [{curvature: 0.009 m-1, "
                   "moment: 500 kN*m}, {curvature: 0.02 m-1, moment: 640 kN*m}]}\n");
  text.replace(text.find(wall), wall.size(), "steel: {outside_diameter: 40.64 cm}");  // of 16 in, less its last digit
  const ModelReading reading = read_model_text(text, "good.yaml");
  for (const std::string& line : reading.diagnostics.lines(Severity::error)) ADD_FAILURE() << line;
}

/// Reported if a segment has a yield stress of its own.
TEST(check_settings, strength_that_a_segment_takes_over_from_another_steel_is_warned_of) {
  const auto warned = [](const std::string& steel, const std::string& segment, const std::string& message) {
    std::string text = testing::kGoodModel;
    const std::string yield = "    yield_stress: 414 MPa\n", wall = "steel: {wall_thickness: 20 mm}";
    text.replace(text.find(yield), yield.size(), yield + steel);
    text.replace(text.find(wall), wall.size(), "steel: {" + segment + "}");
    const std::vector<std::string> lines = read_model_text(text, "good.yaml").diagnostics.lines(Severity::warning);
    return std::ranges::any_of(lines, [&](const std::string& line) {
      return line.find("pipe.segments[0].steel.yield_stress") != std::string::npos &&
             line.find(message) != std::string::npos;
    });
  };
  const std::string strength = "    tensile_strength: 517 MPa\n", reported = "the tensile strength stays";
  EXPECT_TRUE(warned(strength, "yield_stress: 358 MPa", reported));
  EXPECT_FALSE(warned(strength, "yield_stress: 358 MPa, tensile_strength: 455 MPa", reported));
  EXPECT_FALSE(warned(strength, "wall_thickness: 20 mm", reported));
  EXPECT_FALSE(warned("", "yield_stress: 358 MPa", reported));  // that of its grade
  EXPECT_TRUE(
      warned("    material: {law: stress_strain, stress_strain: [{strain: 0.2 %, stress: 400 MPa}, "
             "{strain: 0.5 %, stress: 414 MPa}]}\n",
             "yield_stress: 358 MPa", "the stress-strain curve stays"));
}

}  // namespace
}  // namespace overbend
