/// The program on models that are lines by themselves.
#include <gtest/gtest.h>

#include "base/json.h"
#include "program.h"

namespace overbend {
namespace {

using testing::run_program;
using testing::Scratch;

const std::string kJumper = R"(overbend: 1
title: jumper
environment:
  water_depth: 100 m
  water_weight_density: 9.807 kN/m^3
  seabed: {stiffness: 100 kN/m^2}
lines:
  - name: jumper
    ends:
      - {fixed: {x: -100 m, y: 0 m, z: -55 m}}
      - {fixed: {x: 0 m, y: 0 m, z: -5 m}, motion: {amplitude: {x: 10 m}, period: 27 s}}
    segments:
      - {length: 170 m, diameter: 0.396 m, mass: 165 kg/m, axial_stiffness: 500 MN, bending_stiffness: 120.8 kN*m^2, hydrodynamics: {drag_normal: 1}}
analysis:
  dynamic: {duration: 27 s, build_up: 27 s, max_step: 0.2 s}
)";

TEST(lines_command, static_finds_the_published_forces_on_the_ends) {
  const Scratch scratch;
  const auto done = run_program("static " + scratch.write("jumper.yaml", kJumper) + " -o " + scratch.file("out"));
  ASSERT_EQ(done.code, 0) << done.err;
  const Json line = read_json(scratch.read("out/summary.json"))["static"]["lines"][0];
  EXPECT_NEAR(line["second"]["force"]["x"], 11.40e3, 50.0);
  EXPECT_NEAR(line["second"]["force"]["z"], 45.71e3, 50.0);
  EXPECT_NE(done.out.find("second end"), std::string::npos);
}

TEST(lines_command, dynamic_finds_the_published_extremes) {
  const Scratch scratch;
  const auto done = run_program("dynamic " + scratch.write("jumper.yaml", kJumper) + " -o " + scratch.file("out"));
  ASSERT_EQ(done.code, 0) << done.err;
  const Json line = read_json(scratch.read("out/summary.json"))["dynamic"]["lines"][0];
  EXPECT_NEAR(line["second_tension"]["max"], 52.24e3, 0.02 * 52.24e3);
  EXPECT_NEAR(line["second_tension"]["min"], 41.48e3, 0.02 * 41.48e3);
}

TEST(lines_command, dynamic_takes_the_duration_that_is_given_where_the_model_has_none) {
  const Scratch scratch;
  std::string model = kJumper;
  model.erase(model.find("analysis:"));
  const std::string file = scratch.write("jumper.yaml", model);
  const auto rejected = run_program("dynamic " + file + " -o " + scratch.file("out"));
  EXPECT_EQ(rejected.code, 2);
  EXPECT_NE(rejected.err.find("jumper.yaml:1: analysis.dynamic: "), std::string::npos) << rejected.err;
  const auto done = run_program("dynamic " + file + " --duration '2 s' -o " + scratch.file("out"));
  ASSERT_EQ(done.code, 0) << done.err;
  EXPECT_GT(read_json(scratch.read("out/summary.json"))["dynamic"]["steps"], 0);
}

TEST(lines_command, dynamic_runs_every_seed_and_reports_them_together) {
  const Scratch scratch;
  std::string model = kJumper.substr(0, kJumper.find("lines:"));
  model += "  waves: {type: jonswap, hs: 2 m, tp: 8 s, from: 180 deg, components: 20}\n";
  model += kJumper.substr(kJumper.find("lines:"));
  model.replace(model.find("duration: 27 s, build_up: 27 s"), 30, "duration: 4 s, build_up: 4 s, seeds: [1, 2]");
  const auto done = run_program("dynamic " + scratch.write("jumper.yaml", model) + " -o " + scratch.file("out"));
  ASSERT_EQ(done.code, 0) << done.err;
  const Json seeds = read_json(scratch.read("out/summary.json"))["seeds"];
  const Json item = read_json(scratch.read("out/seed-2/summary.json"))["dynamic"]["lines"][0];
  ASSERT_EQ(seeds["runs"].size(), 2U);
  EXPECT_EQ(seeds["runs"][1]["jumper/second_tension_max"], item["second_tension"]["max"]);
  EXPECT_NE(seeds["runs"][0]["jumper/second_tension_max"], seeds["runs"][1]["jumper/second_tension_max"]);
  EXPECT_NE(scratch.read("out/seeds.csv").find("jumper/second_tension_max [kN]"), std::string::npos);
}

TEST(lines_command, says_what_a_run_needs) {
  const Scratch scratch;
  const std::string at_rest = kJumper.substr(0, kJumper.find("analysis:"));
  const auto done = run_program("dynamic " + scratch.write("jumper.yaml", at_rest) + " -o " + scratch.file("out"));
  EXPECT_EQ(done.code, 2);
  EXPECT_NE(done.err.find("analysis.dynamic"), std::string::npos) << done.err;
}

}  // namespace
}  // namespace overbend
