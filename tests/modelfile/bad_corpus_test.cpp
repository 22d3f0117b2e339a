// The corpus of bad files, and the claim that the reader names each error.
#include <gtest/gtest.h>

#include <algorithm>

#include "modelfile/model_texts.h"
#include "modelfile/reading/yaml_reader.h"

namespace overbend::testing {

const std::vector<Spoiling>& bad_corpus() {
  static const std::vector<Spoiling> kCorpus = {
      {"no_version", "overbend: 1\n", "", "title:", "overbend", "missing", true},
      {"other_version", "overbend: 1", "overbend: 2", "", "overbend", "exactly 1", true},
      {"unknown_top_key", "title: a", "titel: a", "", "titel", "did you mean 'title'", true},
      {"misspelt_key", "wall_thickness: 11", "wall_thicknes: 11", "", "pipe.steel.wall_thicknes", "'wall_thickness'",
       true},
      {"misspelt_key_in_list", "thickness: 3.2 mm", "thick: 3.2 mm", "", "pipe.coatings[0].thick", "'thickness'", true},
      {"misspelt_box_key", "offset: 10 mm", "ofset: 10 mm", "", "supports.stinger.boxes[0].ofset", "'offset'", true},
      {"missing_group", "environment:", "envirnment:", "", "envirnment", "did you mean 'environment'", true},
      {"missing_key", "    yield_stress: 414 MPa\n", "", "  steel:", "pipe.steel.yield_stress", "missing", true},
      {"missing_key_in_flow_map", "{x: -60 m, z: 3.8 m}", "{x: -60 m}", "", "vessel.stern_shoe.z", "missing", true},
      {"duplicate_key", "    wall_thickness: 11.125 mm\n", "    wall_thickness: 11.125 mm\n    wall_thickness: 12 mm\n",
       "wall_thickness: 12 mm", "pipe.steel.wall_thickness", "already in line 18", false},
      {"duplicate_group", "tensioner:\n", "vessel: {}\ntensioner:\n", "vessel: {}", "vessel", "second time", false},
      {"material_without_exponent", "    yield_stress: 414 MPa\n",
       "    yield_stress: 414 MPa\n    material: {law: ramberg_osgood}\n", "law: ramberg_osgood",
       "pipe.steel.material.hardening_exponent", "missing", false},
      {"material_without_law", "    yield_stress: 414 MPa\n",
       "    yield_stress: 414 MPa\n    material: {hardening_exponent: 25}\n", "material: {", "pipe.steel.material.law",
       "without one the steel is linear", false},
      {"material_of_unknown_law", "    yield_stress: 414 MPa\n",
       "    yield_stress: 414 MPa\n    material: {law: trilinear}\n", "law: trilinear", "pipe.steel.material.law",
       "trilinear", true},
      {"moment_form_with_half_its_numbers", "    yield_stress: 414 MPa\n",
       "    yield_stress: 414 MPa\n    material: {law: moment_ramberg_osgood, moment_coefficient: 0.05}\n",
       "moment_coefficient", "pipe.steel.material.moment_exponent", "both A and B", false},
      {"curve_steeper_than_elastic", "    yield_stress: 414 MPa\n",
       "    yield_stress: 414 MPa\n    material: {law: stress_strain, stress_strain: [{strain: 0.1 %, stress: 414 "
       "MPa}]}\n",
       "stress_strain: [", "pipe.steel.material.stress_strain[0]", "steeper than Young's modulus", false},
      {"curve_whose_first_point_is_not_elastic", "    yield_stress: 414 MPa\n",
       "    yield_stress: 414 MPa\n    material: {law: stress_strain, stress_strain: [{strain: 0.5 %, stress: 450 "
       "MPa}]}\n",
       "stress_strain: [", "pipe.steel.material.stress_strain[0]", "a first point below Young's modulus", false},
      {"curve_that_falls_back", "    yield_stress: 414 MPa\n",
       "    yield_stress: 414 MPa\n    material: {law: stress_strain, stress_strain: [{strain: 0.2 %, stress: 414 "
       "MPa}, "
       "{strain: 0.1 %, stress: 420 MPa}]}\n",
       "stress_strain: [", "pipe.steel.material.stress_strain[1]", "does not increase", false},
      {"moment_curve_of_another_wall", "    yield_stress: 414 MPa\n",
       "    yield_stress: 414 MPa\n    material: {law: moment_curvature, moment_curvature: [{curvature: 0.009 m-1, "
       "moment: 500 kN*m}, {curvature: 0.02 m-1, moment: 640 kN*m}]}\n",
       "    - {name: thick end", "pipe.segments[0].steel", "for another pipe", false},
      {"bare_tension", "tension: 250 kN", "tension: 250", "", "tensioner.tension", "write it as '250 kN'", true},
      {"misspelt_tension", "tension: 250 kN", "tenson: 250 kN", "", "tensioner.tenson", "'tension'", true},
      {"bad_value_for_roller_name", "    roller: flat", "    roller: [flat]", "", "supports.stinger.roller", "a list",
       true},
      {"roller_kind_of_wrong_shape", "  flat:\n    bottom: {radius: 0.2 m, face: 1 m}", "  flat: 3", "", "rollers.flat",
       "a group", true},
      {"wave_height_without_unit", "hs: 4 m", "hs: 4", "", "environment.waves.hs", "'4 m'", true},
      {"no_unit", "water_depth: 89 m", "water_depth: 89", "", "environment.water_depth", "without a unit", true},
      {"zero_without_unit", "offset: 10 mm", "offset: 0", "", "supports.stinger.boxes[0].offset", "without a unit",
       true},
      {"wrong_dimension", "water_depth: 89 m", "water_depth: 89 kN", "", "environment.water_depth", "a force", false},
      {"angle_for_length", "draught: 5 m", "draught: 5 deg", "", "vessel.draught", "an angle", false},
      {"ratio_for_angle", "heading: 90 deg", "heading: 90 %", "", "vessel.heading", "a plain number", false},
      {"mass_for_weight", "9.32 kN/m^3", "950 kg/m^3", "", "pipe.coatings[0].weight_density", "9.3163 kN/m^3", false},
      {"unknown_unit", "414 MPa", "414 mPaa", "", "pipe.steel.yield_stress", "unknown unit", false},
      {"unit_in_wrong_case", "414 MPa", "414 mpa", "", "pipe.steel.yield_stress", "'MPa'", false},
      {"unit_where_none_belongs", "friction: 0.1", "friction: 0.1 m", "", "rollers.v.friction", "takes no unit", true},
      {"unit_on_a_count", "rows: 3", "rows: 3 m", "", "supports.ramp.rows", "takes no unit", true},
      {"decimal_comma", "water_depth: 89 m", "water_depth: 89,5 m", "", "environment.water_depth", "decimal sign",
       true},
      {"nan", "poissons_ratio: 0.3", "poissons_ratio: .nan", "", "pipe.steel.poissons_ratio", "not a finite", true},
      {"inf", "tolerance: 1e-8", "tolerance: .inf", "", "analysis.static.tolerance", "not a finite", true},
      {"nan_quantity", "delay: 2 s", "delay: .nan s", "", "tensioner.delay", "'.nan s'", true},
      {"huge_number", "delay: 2 s", "delay: 1e400 s", "", "tensioner.delay", "not a decimal number", false},
      {"huge_value", "x: -48.9 m", "x: -4e17 m", "", "tensioner.x", "exceeds any sensible value", false},
      {"octal_look", "rows: 3", "rows: 012", "", "supports.ramp.rows", "leading zero", false},
      {"octal_look_quantity", "delay: 2 s", "delay: 02 s", "", "tensioner.delay", "leading zero", true},
      {"hexadecimal", "rows: 3", "rows: 0x3", "", "supports.ramp.rows", "whole number", true},
      {"number_in_quotes", "poissons_ratio: 0.3", "poissons_ratio: \"0.3\"", "", "pipe.steel.poissons_ratio", "quotes",
       true},
      {"fraction_for_a_count", "rows: 3", "rows: 2.5", "", "supports.ramp.rows", "whole number", true},
      {"word_for_number", "drag_normal: 1.2", "drag_normal: high", "", "pipe.hydrodynamics.drag_normal", "number",
       true},
      {"group_for_value", "water_depth: 89 m", "water_depth: {a: 1}", "", "environment.water_depth", "a group", true},
      {"list_for_value", "water_depth: 89 m", "water_depth: [89 m]", "", "environment.water_depth", "a list", true},
      {"value_for_group", "    bottom: {radius: 0.15 m, face: 0.6 m}", "    bottom: 0.15 m", "", "rollers.v.bottom",
       "a group", true},
      {"nothing_for_value", "heading: 90 deg", "heading:", "", "vessel.heading", "found nothing", true},
      {"wall_thicker_than_radius", "11.125 mm", "0.3 m", "", "pipe.steel.wall_thickness", "203.2 mm", false},
      {"segment_wall_thicker_than_radius", "wall_thickness: 20 mm", "wall_thickness: 210 mm", "",
       "pipe.segments[0].steel.wall_thickness", "203.2 mm", false},
      {"wall_zero", "11.125 mm", "0 mm", "", "pipe.steel.wall_thickness", "above 0", false},
      {"depth_zero", "water_depth: 89 m", "water_depth: 0 m", "", "environment.water_depth", "above 0", false},
      {"depth_negative", "water_depth: 89 m", "water_depth: -89 m", "", "environment.water_depth", "above 0", false},
      {"poisson_half", "poissons_ratio: 0.3", "poissons_ratio: 0.5", "", "pipe.steel.poissons_ratio", "below 0.5",
       true},
      {"poisson_zero", "poissons_ratio: 0.3", "poissons_ratio: 0", "", "pipe.steel.poissons_ratio", "above 0", true},
      {"negative_friction", "friction: 0.1", "friction: -0.1", "", "rollers.v.friction", "from 0", true},
      {"negative_box_length", "z: 1.1 m, length: 3 m", "z: 1.1 m, length: -3 m", "", "supports.ramp.boxes[0].length",
       "from 0 m", false},
      {"strength_below_yield", "    yield_stress: 414 MPa\n",
       "    yield_stress: 414 MPa\n    tensile_strength: 400 MPa\n", "tensile_strength", "pipe.steel.tensile_strength",
       "at least the yield stress", false},
      {"joint_in_the_wrong_unit", "joint: {length: 12 m", "joint: {length: 12 mm", "", "pipe.joint.length",
       "from 0.1 m", false},
      {"field_joint_as_long_as_joint", "field_joint: 0.6 m", "field_joint: 12 m", "", "pipe.joint.field_joint", "12 m",
       false},
      {"draught_above_depth", "draught: 5 m", "draught: 9.5 m", "", "vessel.draught", "9 m", false},
      {"current_out_of_order", "{depth: 20 m", "{depth: 0 m", "- {depth: 0 m, speed: 0.5",
       "environment.current[1].depth", "increasing depth", false},
      {"current_above_water", "{depth: 0 m", "{depth: -1 m", "", "environment.current[0].depth", "from 0 m", false},
      {"unknown_wave_type", "type: jonswap", "type: johnswap", "", "environment.waves.type", "'jonswap'", true},
      {"sea_without_height", "hs: 4 m, ", "", "waves:", "environment.waves.hs", "missing", false},
      {"breaking_wave", "type: jonswap, hs: 4 m, tp: 12.9 s", "type: airy, height: 12 m, period: 6 s", "",
       "environment.waves.height", "breaks in a water depth of 89 m", false},
      {"breaking_stokes_wave", "type: jonswap, hs: 4 m, tp: 12.9 s", "type: stokes5, height: 12 m, period: 6 s", "",
       "environment.waves.height", "breaks in a water depth of 89 m", false},
      {"stokes_wave_too_long_for_its_theory", "type: jonswap, hs: 4 m, tp: 12.9 s",
       "type: stokes5, height: 8 m, period: 100 s", "", "environment.waves.height", "beyond Stokes' theory", false},
      {"regular_wave_without_period", "type: jonswap", "type: airy, height: 2 m", "", "environment.waves.period",
       "missing", false},
      {"unknown_contact", "supports:\n", "supports:\n  contact: springs\n", "contact: springs", "supports.contact",
       "gap_springs", true},
      {"unknown_damping", "friction: 0.1", "damping: none", "", "rollers.v.damping", "clipped", true},
      {"single_step_for_an_impact", "seeds: [3, 4]", "impact_steps: 1", "", "analysis.dynamic.impact_steps", "from 2",
       true},
      {"impact_force_without_unit", "seeds: [3, 4]", "impact_force: 500", "", "analysis.dynamic.impact_force",
       "without a unit", true},
      {"unknown_motion",
       "motion: {harmonic: {heave: {amplitude: 1 m, period: 8 s, phase: 30 deg}, pitch: {amplitude: 2 deg, "
       "period: 9 s}}}",
       "motion: moored", "", "vessel.motion", "'fixed'", true},
      {"two_motions", "motion: {harmonic:", "motion: {raos: a.csv, harmonic:", "", "vessel.motion", "1 of raos", false},
      {"unknown_freedom", "heave: {", "heavy: {", "", "vessel.motion.harmonic.heavy", "'heave'", true},
      {"length_for_a_rotation", "amplitude: 2 deg", "amplitude: 2 m", "", "vessel.motion.harmonic.pitch.amplitude",
       "a length", false},
      {"no_tension", "  tension: 250 kN\n", "", "tensioner:", "tensioner.tension", "pipe.length and pipe.anchor",
       false},
      {"tension_and_length_and_anchor", "  hydrodynamics:", "  anchor: 900 m\n  length: 1 km\n  hydrodynamics:",
       "length: 1 km", "pipe.length", "two of the three", false},
      {"anchor_beside_tension", "  hydrodynamics:", "  anchor: 900 m\n  hydrodynamics:", "anchor: 900 m", "pipe.anchor",
       "an anchor distance and tensioner.tension", false},
      {"segments_longer_than_line",
       "  hydrodynamics:", "  length: 20 m\n  hydrodynamics:", "segments:", "pipe.segments", "24 m together", false},
      {"range_reversed", "[240 kN, 260 kN]", "[260 kN, 240 kN]", "", "tensioner.range", "lower tension first", false},
      {"range_of_one", "[240 kN, 260 kN]", "[240 kN]", "", "tensioner.range", "exactly 2", true},
      {"controlled_without_range", "  range: [240 kN, 260 kN]\n", "  mode: controlled\n",
       "tensioner:", "tensioner.range", "missing", false},
      {"unknown_mode", "  delay: 2 s", "  mode: contant", "", "tensioner.mode", "'constant'", true},
      {"side_roller_level", "angle: 60 deg", "angle: 0 deg", "", "rollers.v.sides.angle", "above 0 deg", false},
      {"side_roller_beyond_upright", "angle: 60 deg", "angle: 91 deg", "", "rollers.v.sides.angle", "at most 90 deg",
       false},
      {"restitution_above_one", "friction: 0.1", "restitution: 1.1", "", "rollers.v.restitution", "0 to 1", true},
      {"unknown_roller_kind", "    roller: v\n", "    roller: w1\n", "", "supports.ramp.roller", "one of v or flat",
       false},
      {"unknown_roller_kind_of_a_box", "roller: v, incline", "roller: flaat, incline", "",
       "supports.stinger.boxes[0].roller", "'flat'", false},
      {"box_without_roller", "    roller: flat\n", "", "- {x: 9 m", "supports.stinger.boxes[1].roller", "missing",
       false},
      {"no_rollers_at_all", "rollers:\n", "kinds:\n", "roller: v\n", "supports.ramp.roller", "add the group rollers",
       true},
      {"no_rows", "rows: 3", "rows: 0", "", "supports.ramp.rows", "from 1", true},
      {"rows_without_length", "- {x: 9 m, z: -5.7 m}", "- {x: 9 m, z: -5.7 m, rows: 2}", "",
       "supports.stinger.boxes[1].length", "2 rows", false},
      {"no_boxes",
       "    roller: flat\n    boxes:\n      - {name: tip, x: 5.23 m, z: -4.5 m, offset: 10 mm, roller: v, incline: "
       "12 deg}\n      - {x: 9 m, z: -5.7 m}\n",
       "    roller: flat\n    boxes: []\n", "boxes: []", "supports.stinger.boxes", "an empty list", true},
      {"boxes_out_of_order", "x: -9 m", "x: -40 m", "", "supports.ramp.boxes[1].x", "box 'ramp 1'", false},
      {"stinger_before_ramp", "x: 5.23 m", "x: -10 m", "", "supports.stinger.boxes[0].x", "box 'ramp 2'", false},
      {"box_before_tensioner", "x: -39 m", "x: -49 m", "", "supports.ramp.boxes[0].x", "the tensioner", false},
      {"boxes_of_one_name", "name: ramp 2", "name: ramp 1", "name: ramp 1, x: -9 m", "supports.ramp.boxes[1].name",
       "already used in line", false},
      {"two_steps", "max_step: 0.1 s", "max_step: 0.1 s, step: 0.1 s", "", "analysis.dynamic.max_step", "one of them",
       false},
      {"no_duration", "duration: 3 h, ", "", "dynamic:", "analysis.dynamic.duration", "missing", true},
      {"empty_title", "title: a good model", "title: ''", "", "title", "empty text", true},
      {"anchor", "depth: 9 m", "depth: &d 9 m", "", "vessel.depth", "anchors are not used", false},
      {"alias", "depth: 9 m\n  draught: 5 m", "depth: &d 9 m\n  draught: *d", "draught:", "vessel.draught",
       "aliases are not used", false},
      {"tag", "depth: 9 m", "depth: !!str 9 m", "", "vessel.depth", "tags are not used", false},
      {"second_document", "analysis:", "---\nanalysis:", "analysis:", "", "second document", false},
      {"unclosed_bracket", "[240 kN, 260 kN]", "[240 kN, 260 kN", "", "", "not closed", false},
      {"bad_indent", "  heading: 90 deg", "   heading: 90 deg", "", "", "invalid YAML", false},
      {"tab", "  heading: 90 deg", "\theading: 90 deg", "", "", "invalid YAML", false},
      {"control_character", "a good model", "a \x01 model", "", "", "not a text file", false},
      {"no_text", "a good model", "a \xff model", "", "", "not a text file", false},
  };
  return kCorpus;
}

namespace {

/// Line tolerance of syntax errors: the parser notices some of them a line or two further on.
int slack(const Spoiling& s) {
  return s.expected_text == "invalid YAML" || s.expected_text == "not closed" ? 2 : 0;
}

TEST(bad_file, the_model_that_the_corpus_spoils_is_good) {
  const ModelReading reading = read_model_text(kGoodModel, "good.yaml");
  EXPECT_TRUE(reading.description.has_value());
  for (const std::string& line : reading.diagnostics.lines(Severity::error)) ADD_FAILURE() << line;
}

TEST(bad_file, every_error_is_reported_with_line_key_and_remedy) {
  for (const Spoiling& s : bad_corpus()) {
    const std::string text = spoil(s);
    ASSERT_FALSE(text.empty()) << s.claim << ": '" << s.find << "' is not in the good model";
    const ModelReading reading = read_model_text(text, "bad.yaml");
    EXPECT_FALSE(reading.description.has_value()) << s.claim;
    const int line = find_line_number(text, s.line_text.empty() ? s.replace : s.line_text);
    bool reported = false;
    std::string all;
    for (const Diagnostic& d : reading.diagnostics.sorted()) {
      all += "\n  " + render(d);
      reported = reported || (d.severity == Severity::error && d.key == s.key && std::abs(d.line - line) <= slack(s) &&
                              render(d).find(s.expected_text) != std::string::npos);
    }
    EXPECT_TRUE(reported) << s.claim << ": wanted line " << line << ", key '" << s.key << "', words '"
                          << s.expected_text << "'" << all;
  }
}

TEST(bad_file, a_single_error_makes_a_single_complaint) {
  const std::vector<std::string> kSeveral = {"no_rollers_at_all", "alias",           "bad_indent",   "no_tension",
                                             "duplicate_group",   "second_document", "decimal_comma"};
  for (const Spoiling& s : bad_corpus()) {
    if (std::find(kSeveral.begin(), kSeveral.end(), s.claim) != kSeveral.end()) continue;
    const ModelReading reading = read_model_text(spoil(s), "bad.yaml");
    EXPECT_EQ(reading.diagnostics.error_count(), 1) << s.claim;
  }
}

TEST(bad_file, all_errors_are_reported_in_one_go) {
  std::string text = kGoodModel;
  int spoilt = 0;
  for (const char* claim :
       {"misspelt_key", "no_unit", "poisson_half", "side_roller_level", "boxes_out_of_order", "no_duration"}) {
    const auto s = std::find_if(bad_corpus().begin(), bad_corpus().end(),
                                [&](const Spoiling& x) { return std::string(x.claim) == claim; });
    text.replace(text.find(s->find), s->find.size(), s->replace);
    ++spoilt;
  }
  EXPECT_EQ(read_model_text(text, "bad.yaml").diagnostics.error_count(), spoilt);
}

}  // namespace
}  // namespace overbend::testing
