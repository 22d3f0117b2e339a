#include "modelfile/reading/yaml_reader.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <numbers>

#include "base/constants.h"
#include "modelfile/model_texts.h"
#include "support/rao_files.h"

namespace overbend {
namespace {

using testing::kGoodModel;

Description read_good(const std::string& text) {
  const ModelReading reading = read_model_text(text, "folder/good.yaml");
  for (const std::string& line : reading.diagnostics.lines(Severity::error)) ADD_FAILURE() << line;
  return reading.description.value_or(Description{});
}

TEST(yaml_reader, every_model_of_the_repository_is_read_without_a_word) {
  ASSERT_GE(testing::good_files().size(), 10U);
  for (const auto& path : testing::good_files()) {
    const ModelReading reading = read_model(path.string());
    EXPECT_TRUE(reading.description.has_value()) << path;
    for (const Diagnostic& d : reading.diagnostics.sorted()) ADD_FAILURE() << render(d);
  }
}

// Thirty thousand keys: compared each with each they would take seconds.
TEST(yaml_reader, a_key_that_comes_twice_is_found_among_very_many) {
  std::string text = "overbend: 1\n";
  for (int i = 0; i < 30000; ++i) text += "k" + std::to_string(i) + ": 1\n";
  const ModelReading reading = read_model_text(text + "k7: 1\n", "many.yaml");
  const std::vector<std::string> lines = reading.diagnostics.lines(Severity::error);
  EXPECT_TRUE(std::any_of(lines.begin(), lines.end(), [](const std::string& line) {
    return line.find(": k7") != std::string::npos && line.find("already in line 9") != std::string::npos;
  }));
}

TEST(yaml_reader, lists_and_groups_longer_than_anything_sensible_are_one_error) {
  std::string kinds = "rollers:\n", profile = "environment:\n  water_depth: 40 m\n  current:\n";
  for (int i = 0; i < 10001; ++i) {
    kinds += "  k" + std::to_string(i) + ": {bottom: {radius: 0.15 m, face: 1 m}}\n";
    profile += "    - {depth: 1 m, speed: 1 m/s, towards: 0 deg}\n";
  }
  const std::string all = "overbend: 1\n" + kinds + profile;
  int found = 0;
  for (const std::string& line : read_model_text(all, "long.yaml").diagnostics.lines(Severity::error)) {
    found += line.find("a group of 10001 keys, expected at most 10000") != std::string::npos ? 1 : 0;
    found += line.find("a list of 10001, expected at most 10000") != std::string::npos ? 1 : 0;
  }
  EXPECT_EQ(found, 2);
}

TEST(yaml_reader, the_example_arrives_in_si) {
  const ModelReading reading = read_model(std::string(OVERBEND_SOURCE_DIR) + "/examples/bgl1.yaml");
  ASSERT_TRUE(reading.description.has_value());
  const Description& d = *reading.description;
  EXPECT_EQ(d.title, "BGL-1 16-inch S-lay, 89 m");
  EXPECT_DOUBLE_EQ(d.environment.water_depth, 89.0);
  EXPECT_DOUBLE_EQ(d.environment.water_weight_density, 10050.0);
  EXPECT_DOUBLE_EQ(d.environment.seabed.stiffness, 1e5);
  EXPECT_DOUBLE_EQ(d.environment.seabed.friction_lateral, 0.5);
  ASSERT_EQ(d.environment.current.size(), 5U);
  EXPECT_DOUBLE_EQ(d.environment.current[2].speed, 0.45);
  EXPECT_EQ(d.environment.waves.front().type, WaveType::jonswap);
  EXPECT_DOUBLE_EQ(d.environment.waves.front().tp, 12.9);
  EXPECT_DOUBLE_EQ(d.environment.waves.front().from, std::numbers::pi);
  const SectionDescription& pipe = d.pipe.section;
  EXPECT_DOUBLE_EQ(pipe.steel.outside_diameter, 0.4064);
  EXPECT_DOUBLE_EQ(pipe.steel.wall_thickness, 0.011125);
  EXPECT_DOUBLE_EQ(pipe.steel.youngs_modulus, 207e9);
  EXPECT_DOUBLE_EQ(pipe.steel.yield_stress, 414e6);
  ASSERT_EQ(pipe.coatings.size(), 2U);
  EXPECT_EQ(pipe.coatings[1].name, "concrete");
  EXPECT_DOUBLE_EQ(pipe.coatings[1].weight_density, 21974.0);
  ASSERT_TRUE(pipe.joint.has_value());
  EXPECT_DOUBLE_EQ(pipe.joint->field_joint, 0.6);
  EXPECT_DOUBLE_EQ(pipe.hydrodynamics.drag_axial, 0.03);
  EXPECT_DOUBLE_EQ(d.vessel.stern_shoe_z, 3.818);
  EXPECT_DOUBLE_EQ(d.vessel.heading, std::numbers::pi / 2.0);
  EXPECT_EQ(d.vessel.motion, VesselMotion::raos);
  EXPECT_TRUE(std::filesystem::exists(d.vessel.motion_file)) << d.vessel.motion_file;
  EXPECT_DOUBLE_EQ(d.tensioner.tension.value_or(0.0), 250e3);
  EXPECT_DOUBLE_EQ(d.tensioner.range_high.value_or(0.0), 260e3);
  EXPECT_EQ(d.tensioner.mode, TensionerMode::controlled);
  EXPECT_EQ(d.tensioner.guide, Guide::clamped);
  ASSERT_EQ(d.rollers.size(), 1U);
  EXPECT_NEAR(d.rollers[0].sides->angle, 60.0 * kDegree, 1e-15);
  EXPECT_DOUBLE_EQ(d.rollers[0].friction_axial, 0.02);
  EXPECT_FALSE(d.rollers[0].stiffness.has_value());
  ASSERT_EQ(d.supports.boxes.size(), 13U);
  EXPECT_EQ(d.supports.boxes[4].structure, Structure::ramp);
  EXPECT_EQ(d.supports.boxes[5].structure, Structure::stinger);
  EXPECT_DOUBLE_EQ(d.supports.boxes[12].offset, 0.412);
  EXPECT_EQ(d.supports.boxes[12].rows, 3);
  EXPECT_FALSE(d.supports.stinger_radius.has_value());
  ASSERT_TRUE(d.dynamics.has_value());
  EXPECT_DOUBLE_EQ(d.dynamics->duration, 10800.0);
  EXPECT_DOUBLE_EQ(d.dynamics->spectral_radius, 0.6);
}

TEST(yaml_reader, boxes_override_what_their_structure_says) {
  const Description d = read_good(kGoodModel);
  ASSERT_EQ(d.supports.boxes.size(), 4U);
  EXPECT_EQ(d.supports.boxes[0].rows, 3);
  EXPECT_EQ(d.supports.boxes[1].rows, 2);
  EXPECT_EQ(d.supports.boxes[2].roller, "v");
  EXPECT_EQ(d.supports.boxes[3].roller, "flat");
  EXPECT_EQ(d.supports.boxes[3].rows, 1);
  EXPECT_EQ(d.supports.boxes[3].name, "stinger 2");
  EXPECT_NEAR(d.supports.boxes[2].incline.value_or(0.0), 12.0 * kDegree, 1e-15);
  EXPECT_FALSE(d.supports.boxes[3].incline.has_value());
}

TEST(yaml_reader, a_segment_inherits_what_it_leaves_out) {
  const Description d = read_good(kGoodModel);
  ASSERT_EQ(d.pipe.segments.size(), 1U);
  const SectionDescription& segment = d.pipe.segments[0].section;
  EXPECT_DOUBLE_EQ(segment.steel.wall_thickness, 0.020);
  EXPECT_DOUBLE_EQ(segment.steel.outside_diameter, 0.4064);
  EXPECT_DOUBLE_EQ(segment.hydrodynamics.drag_normal, 1.2);
  EXPECT_EQ(segment.coatings.size(), 2U);
  EXPECT_TRUE(segment.joint.has_value());
}

TEST(yaml_reader, one_friction_serves_both_directions_and_a_group_serves_each) {
  const Description d = read_good(kGoodModel);
  EXPECT_DOUBLE_EQ(d.rollers[0].friction_axial, 0.1);
  EXPECT_DOUBLE_EQ(d.rollers[0].friction_lateral, 0.1);
  EXPECT_DOUBLE_EQ(d.rollers[1].friction_lateral, 0.0);
  EXPECT_DOUBLE_EQ(d.environment.seabed.friction_axial, 0.5);
  EXPECT_DOUBLE_EQ(d.environment.seabed.friction_lateral, 0.6);
}

TEST(yaml_reader, vessel_motion_takes_all_its_forms) {
  const Description harmonic = read_good(kGoodModel);
  EXPECT_EQ(harmonic.vessel.motion, VesselMotion::harmonic);
  ASSERT_EQ(harmonic.vessel.harmonic.size(), 2U);
  EXPECT_NEAR(harmonic.vessel.harmonic.at("heave").phase, 30.0 * kDegree, 1e-15);
  EXPECT_NEAR(harmonic.vessel.harmonic.at("pitch").amplitude, 2.0 * kDegree, 1e-15);

  const std::size_t start = kGoodModel.find("  motion:"), end = kGoodModel.find('\n', start);
  const auto with_motion = [&](const std::string& motion) {
    return read_good(kGoodModel.substr(0, start) + motion + kGoodModel.substr(end));
  };
  EXPECT_EQ(with_motion("").vessel.motion, VesselMotion::fixed);
  EXPECT_EQ(with_motion("  motion: fixed").vessel.motion, VesselMotion::fixed);
  const Description history = with_motion("  motion: {history: ../h.csv}");
  EXPECT_EQ(history.vessel.motion, VesselMotion::history);
  EXPECT_EQ(history.vessel.motion_file, "h.csv");
}

TEST(yaml_reader, columns_of_a_recorded_motion_are_named_by_their_titles) {
  const std::size_t start = kGoodModel.find("  motion:"), end = kGoodModel.find('\n', start);
  const auto read_with = [&](const std::string& motion) {
    const testing::WrittenFile record("h.csv", "Zeit,Rollen,Wind\n0,0.01,3\n1,0.02,4\n2,0.01,4\n");
    const std::string model = (std::filesystem::path(record.path()).parent_path() / "model.yaml").string();
    return read_model_text(kGoodModel.substr(0, start) + motion + kGoodModel.substr(end), model);
  };
  const ModelReading reading =
      read_with("  motion: {history: h.csv, columns: {Zeit: time_s, Rollen: roll_rad, Wind: unused}}");
  ASSERT_TRUE(reading.description) << reading.diagnostics.lines(Severity::error)[0];
  EXPECT_DOUBLE_EQ(reading.description->vessel.history->freedoms[1][3], 0.02);
  EXPECT_NE(read_with("  motion: {history: h.csv}").diagnostics.lines(Severity::error)[0].find("motion.columns"),
            std::string::npos);
  const ModelReading harmonic =
      read_with("  motion: {harmonic: {heave: {amplitude: 1 m, period: 8 s}}, columns: {Zeit: time_s}}");
  ASSERT_TRUE(harmonic.description);
  EXPECT_TRUE(has_code(harmonic.description->findings, FindingCode::unused_input));
}

TEST(yaml_reader, a_stored_text_is_read_without_the_files_that_it_names) {
  std::ifstream in(std::string(OVERBEND_SOURCE_DIR) + "/examples/moored-barge.yaml");
  const std::string text{std::istreambuf_iterator<char>(in), {}};
  EXPECT_FALSE(read_model_text(text, "/nowhere/model.yaml").description);
  const ModelReading stored = read_stored_model(text, "/nowhere/model.yaml");
  ASSERT_TRUE(stored.description);
  EXPECT_EQ(stored.description->moorings->lines.size(), 8u);
  EXPECT_DOUBLE_EQ(stored.description->vessel.coupled->mass, 19121.58e3);
  EXPECT_FALSE(read_stored_model("no: [model", "model.yaml").description);
  EXPECT_FALSE(read_stored_model(std::string("a\xff", 2), "model.yaml").description);
}

TEST(yaml_reader, a_file_that_only_dynamics_needs_is_missed_with_a_warning) {
  std::string text = testing::file_text(std::string(OVERBEND_SOURCE_DIR) + "/examples/bgl1.yaml");
  text.replace(text.find("../data/bgl1/rao.csv"), 20, "nowhere.csv");
  const Description d = read_good(text);
  ASSERT_EQ(d.findings.size(), 1U);
  const std::string place = "good.yaml:" + std::to_string(testing::find_line_number(text, "nowhere.csv"));
  EXPECT_NE(messages(d.findings)[0].find(place + ": vessel.motion.raos: the file 'nowhere.csv'"), std::string::npos)
      << messages(d.findings)[0];
}

TEST(yaml_reader, tensioner_is_controlled_with_a_range_and_keeps_its_tension_without) {
  EXPECT_EQ(read_good(kGoodModel).tensioner.mode, TensionerMode::controlled);
  std::string text = kGoodModel;
  text.erase(text.find("  range:"), std::string("  range: [240 kN, 260 kN]\n").size());
  EXPECT_EQ(read_good(text).tensioner.mode, TensionerMode::constant);
  EXPECT_TRUE(read_good(text).tensioner.mode_assumed);
  const std::string tension = "tension: 250 kN";
  text.insert(text.find(tension) + tension.size(), "\n  mode: locked");
  const Description locked = read_good(text);
  EXPECT_EQ(locked.tensioner.mode, TensionerMode::locked);  // chosen
  EXPECT_FALSE(locked.tensioner.mode_assumed);
}

TEST(yaml_reader, a_range_that_does_not_hold_the_tension_is_a_warning_for_statics_sweep_the_tension) {
  std::string text(kGoodModel);
  const std::string tension = "tension: 250 kN";
  ASSERT_NE(text.find(tension), std::string::npos);
  text.replace(text.find(tension), tension.size(), "tension: 300 kN");
  const Description d = read_good(text);
  ASSERT_FALSE(d.findings.empty());
  EXPECT_NE(messages(d.findings).back().find("does not contain the set tension, '300 kN'"), std::string::npos)
      << messages(d.findings).back();
}

TEST(yaml_reader, length_and_anchor_serve_in_place_of_the_tension) {
  std::string text = kGoodModel;
  text.replace(text.find("  tension: 250 kN\n"), 18, "");
  text.replace(text.find("  hydrodynamics:"), 0, "  length: 900 m\n  anchor: 0.8 km\n");
  const Description d = read_good(text);
  EXPECT_DOUBLE_EQ(d.pipe.length.value_or(0.0), 900.0);
  EXPECT_DOUBLE_EQ(d.pipe.anchor.value_or(0.0), 800.0);
  EXPECT_FALSE(d.tensioner.tension.has_value());
}

TEST(yaml_reader, seeds_are_a_list_or_how_many) {
  EXPECT_EQ(read_good(kGoodModel).dynamics->seeds, (std::vector<std::uint64_t>{3, 4}));
  std::string text = kGoodModel;
  text.replace(text.find("[3, 4]"), 6, "3");
  EXPECT_EQ(read_good(text).dynamics->seeds, (std::vector<std::uint64_t>{1, 2, 3}));
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const std::size_t index = text.find(from);
  EXPECT_NE(index, std::string::npos) << from;
  return text.replace(index, from.size(), to);
}

TEST(yaml_reader, contact_in_time_has_options_for_each_kind_of_roller) {
  const Description d = read_good(
      replaced(kGoodModel, "    friction: 0.1\n", "    damping: textbook\n    tangential_stiffness: 2e4 kN/m\n"));
  EXPECT_EQ(d.rollers[0].damping, RollerDamping::textbook);
  EXPECT_DOUBLE_EQ(d.rollers[0].tangential_stiffness.value_or(0.0), 2e7);
  EXPECT_EQ(d.rollers[1].damping, RollerDamping::clipped);
  EXPECT_FALSE(d.rollers[1].tangential_stiffness.has_value());
}

TEST(yaml_reader, supports_are_rollers_unless_gap_springs_are_asked_for) {
  EXPECT_EQ(read_good(kGoodModel).supports.contact, SupportContact::rollers);
  const Description d = read_good(replaced(kGoodModel, "supports:\n", "supports:\n  contact: gap_springs\n"));
  EXPECT_EQ(d.supports.contact, SupportContact::gap_springs);
  EXPECT_EQ(d.supports.boxes.size(), 4U);
}

TEST(yaml_reader, time_steps_can_be_made_finer) {
  const Description d = read_good(replaced(
      kGoodModel, "seeds: [3, 4]", "impact_steps: 20, impact_force: 300 N, tolerance: 1e-8, step_error: 0.1 mm"));
  ASSERT_TRUE(d.dynamics.has_value());
  EXPECT_DOUBLE_EQ(d.dynamics->impact_steps, 20.0);
  EXPECT_DOUBLE_EQ(d.dynamics->impact_force.value(), 300.0);
  EXPECT_DOUBLE_EQ(d.dynamics->tolerance, 1e-8);
  EXPECT_DOUBLE_EQ(d.dynamics->step_error.value(), 1e-4);
  const Description left_out = read_good(kGoodModel);
  const DynamicSettings settings;
  EXPECT_DOUBLE_EQ(left_out.dynamics->impact_steps, settings.impact_steps);
  EXPECT_FALSE(left_out.dynamics->impact_force);
  EXPECT_DOUBLE_EQ(left_out.dynamics->tolerance, settings.tolerance);
  EXPECT_FALSE(left_out.dynamics->step_error);
}

TEST(yaml_reader, a_controlled_tensioner_without_a_speed_is_reported) {
  const auto warnings = [](const std::string& velocity, const std::string& mode) {
    const Description d = read_good(replaced(kGoodModel, "  velocity: 0.25 m/s\n", velocity + mode));
    return std::ranges::count_if(messages(d.findings),
                                 [](const std::string& w) { return w.find("never moves") != std::string::npos; });
  };
  EXPECT_EQ(warnings("", ""), 1);
  EXPECT_EQ(warnings("", "  mode: controlled\n"), 1);
  EXPECT_EQ(warnings("", "  mode: locked\n"), 0);
  EXPECT_EQ(warnings("", "  mode: constant\n"), 0);
  EXPECT_EQ(warnings("  velocity: 0.25 m/s\n", "  mode: controlled\n"), 0);
}

TEST(yaml_reader, what_is_left_out_keeps_the_default_of_the_description) {
  const std::string min_value = R"(overbend: 1
environment: {water_depth: 400 m, seabed: {stiffness: 150 kN/m^2}}
pipe: {steel: {outside_diameter: 0.3239 m, wall_thickness: 0.0206 m, yield_stress: 414 MPa}}
vessel: {stern_shoe: {x: -60 m, z: 0 m}}
tensioner: {x: 0 m, z: 15 m, tension: 560 kN}
)";
  const Description d = read_good(min_value);
  const Description defaults;
  EXPECT_EQ(d.title, "good");
  EXPECT_DOUBLE_EQ(d.environment.water_weight_density, defaults.environment.water_weight_density);
  EXPECT_DOUBLE_EQ(d.environment.seabed.friction_axial, defaults.environment.seabed.friction_axial);
  EXPECT_EQ(d.environment.waves.front().type, defaults.environment.waves.front().type);
  const SteelDescription steel;
  EXPECT_DOUBLE_EQ(d.pipe.section.steel.youngs_modulus, steel.youngs_modulus);
  EXPECT_DOUBLE_EQ(d.pipe.section.steel.poissons_ratio, steel.poissons_ratio);
  EXPECT_DOUBLE_EQ(d.pipe.section.steel.weight_density, steel.weight_density);
  EXPECT_FALSE(d.pipe.section.joint.has_value());
  const HydrodynamicsDescription hydrodynamics;
  EXPECT_DOUBLE_EQ(d.pipe.section.hydrodynamics.drag_normal, hydrodynamics.drag_normal);
  EXPECT_DOUBLE_EQ(d.pipe.section.hydrodynamics.added_mass_normal, hydrodynamics.added_mass_normal);
  EXPECT_EQ(d.vessel.name, defaults.vessel.name);
  EXPECT_DOUBLE_EQ(d.vessel.draught, defaults.vessel.draught);
  EXPECT_EQ(d.tensioner.guide, Guide::clamped);
  EXPECT_EQ(d.tensioner.mode, TensionerMode::constant);
  EXPECT_TRUE(d.supports.boxes.empty());
  EXPECT_EQ(d.statics.max_iterations, defaults.statics.max_iterations);
  EXPECT_DOUBLE_EQ(d.statics.tolerance, defaults.statics.tolerance);
  EXPECT_FALSE(d.dynamics.has_value());
}

TEST(yaml_reader, the_text_is_kept_as_it_was) {
  EXPECT_EQ(read_good(kGoodModel).source_text, kGoodModel);
}

TEST(yaml_reader, unusual_values_are_taken_with_a_warning) {
  std::string text = kGoodModel;
  text.replace(text.find("414 MPa"), 7, "414 kPa");
  const Description d = read_good(text);
  ASSERT_FALSE(d.findings.empty());
  EXPECT_NE(messages(d.findings)[0].find("pipe.steel.yield_stress"), std::string::npos);
}

/// The good model with `found` written as `written`.
std::string rewritten(const std::string& found, const std::string& written) {
  std::string text = kGoodModel;
  return text.replace(text.find(found), found.size(), written);
}

TEST(yaml_reader, a_plain_number_may_be_written_in_per_cent_as_results_show_it) {
  EXPECT_DOUBLE_EQ(read_good(rewritten("friction: 0.1", "friction: 12.5 %")).rollers[0].friction_axial, 0.125);
}

TEST(yaml_reader, a_unit_of_two_meanings_is_taken_with_a_warning) {
  const Description d = read_good(rewritten("tension: 250 kN", "tension: 25 tonf"));
  ASSERT_FALSE(d.findings.empty());
  EXPECT_NE(messages(d.findings)[0].find("metric tonne-force"), std::string::npos) << messages(d.findings)[0];
}

TEST(yaml_reader, a_tensile_strength_that_no_steel_has_is_warned_of) {
  std::string text = kGoodModel;
  text.replace(text.find("414 MPa"), 7, "414 MPa\n    tensile_strength: 517 GPa");
  const Description d = read_good(text);
  ASSERT_FALSE(d.findings.empty());
  EXPECT_NE(messages(d.findings)[0].find("pipe.steel.tensile_strength"), std::string::npos);
}

TEST(yaml_reader, what_is_no_model_file_is_reported_plainly) {
  const auto complaint = [](const ModelReading& reading) {
    EXPECT_FALSE(reading.description.has_value());
    EXPECT_EQ(reading.diagnostics.error_count(), 1);
    return render(reading.diagnostics.sorted().at(0));
  };
  EXPECT_EQ(complaint(read_model("/nowhere/a.yaml")), "/nowhere/a.yaml: there is no such file");
  EXPECT_EQ(complaint(read_model("/tmp")), "/tmp: this is a folder, not a model file");
  for (const char* empty : {"", "\n\n", "# only a remark\n"}) {
    EXPECT_NE(complaint(read_model_text(empty, "a")).find("empty"), std::string::npos) << empty;
  }
  EXPECT_NE(complaint(read_model_text("just words", "a")).find("not a model file"), std::string::npos);
  EXPECT_NE(complaint(read_model_text("[1, 2]", "a")).find("not a model file"), std::string::npos);
  EXPECT_NE(complaint(read_model_text(std::string(100000, '['), "a")).find("nested too deeply"), std::string::npos);
  EXPECT_NE(complaint(read_model_text(std::string("\0\1\2", 3), "a")).find("not a text file"), std::string::npos);
}

TEST(yaml_reader, windows_line_ends_and_a_byte_order_mark_do_no_harm) {
  std::string text = "\xEF\xBB\xBF";
  for (const char c : kGoodModel) text += c == '\n' ? std::string("\r\n") : std::string(1, c);
  EXPECT_EQ(read_good(text).supports.boxes.size(), 4U);
}

}  // namespace
}  // namespace overbend
