#include <gtest/gtest.h>

#include <algorithm>

#include "app/program.h"
#include "base/json.h"
#include "modelfile/yaml_reader.h"

namespace overbend {
namespace {

using testing::example;
using testing::ProgramRun;
using testing::run_program;
using testing::Scratch;

TEST(command_line, help_and_version_succeed_on_standard_output) {
  for (const char* words : {"--help", "check --help", "new --help", "--version"}) {
    const ProgramRun run = run_program(words);
    EXPECT_EQ(run.code, 0) << words;
    EXPECT_FALSE(run.out.empty()) << words;
    EXPECT_EQ(run.err, "") << words;
  }
}

TEST(command_line, wrong_usage_is_wrong_input) {
  for (const char* words :
       {"", "nonsense", "check", "check a.yaml b.yaml", "--nonsense", "schema --nonsense", "new --boxes no"}) {
    const ProgramRun run = run_program(words);
    EXPECT_EQ(run.code, 2) << words;
    EXPECT_EQ(run.out, "") << words;
    EXPECT_FALSE(run.err.empty()) << words;
  }
}

TEST(command_line, an_instruction_set_that_nobody_knows_is_wrong_input) {
  const ProgramRun run = run_program("check " + example("bgl1.yaml"), "OVERBEND_ISA=nonsense ");
  EXPECT_EQ(run.code, 2);
  EXPECT_EQ(run.out, "");
  EXPECT_NE(run.err.find("found 'nonsense', expected baseline, avx2 or avx512"), std::string::npos) << run.err;
  for (const char* known : {"OVERBEND_ISA=baseline ", "OVERBEND_ISA=avx2 ", "OVERBEND_ISA=avx512 ", "OVERBEND_ISA= "}) {
    EXPECT_EQ(run_program("--version", known).code, 0) << known;
  }
}

TEST(command_line, check_prints_the_published_section_digits) {
  // [silva2009] table 4: EA, EI, weight in air and submerged.
  const ProgramRun run = run_program("check " + example("bgl1.yaml"));
  EXPECT_EQ(run.code, 0);
  EXPECT_EQ(run.err, "");
  for (const char* digits : {"2859694.14 kN", "55894.90 kN m2", "2.255935", "0.368493"}) {
    EXPECT_NE(run.out.find(digits), std::string::npos) << digits << "\n" << run.out;
  }
}

TEST(command_line, check_places_the_supports_in_the_world) {
  // Heading east: astern is -x. Box "ramp 1" stands 39.03 m forward of the shoe at x = -60 m; z = 3.818 + 1.146.
  const ProgramRun run = run_program("check " + example("bgl1.yaml"));
  const std::size_t at = run.out.find("  ramp 1 ");
  ASSERT_NE(at, std::string::npos);
  std::istringstream row(run.out.substr(at));
  std::string word;
  double number = 0.0, x = 0.0, y = 0.0, z = 0.0;
  row >> word >> number >> x >> y >> z;
  EXPECT_NEAR(x, -20.970, 5e-4);
  EXPECT_NEAR(y, 0.0, 5e-4);
  EXPECT_NEAR(z, 4.964, 5e-4);
  EXPECT_NE(run.out.find("13 boxes, 39 rows, 117 rollers"), std::string::npos);
}

TEST(command_line, a_wrong_file_ends_with_two_and_says_where_on_standard_error) {
  const Scratch scratch;
  std::string text = scratch.read("none");
  std::ifstream in(example("bgl1.yaml"));
  std::getline(in, text, '\0');
  text.replace(text.find("wall_thickness"), 14, "wall_thicknes");
  text.replace(text.find("water_depth: 89 m"), 17, "water_depth: 89");
  const std::string file = scratch.write("bad.yaml", text);
  const ProgramRun run = run_program("check " + file);
  EXPECT_EQ(run.code, 2);
  EXPECT_EQ(run.out, "");
  EXPECT_NE(run.err.find("bad.yaml:7: environment.water_depth: found '89' without a unit"), std::string::npos)
      << run.err;
  EXPECT_NE(run.err.find("did you mean 'wall_thickness'?"), std::string::npos) << run.err;
}

TEST(command_line, a_missing_file_ends_with_two) {
  const ProgramRun run = run_program("check /nowhere/model.yaml");
  EXPECT_EQ(run.code, 2);
  EXPECT_EQ(run.err, "/nowhere/model.yaml: there is no such file\n");
}

TEST(command_line, schema_prints_json) {
  const ProgramRun run = run_program("schema");
  EXPECT_EQ(run.code, 0);
  const Json schema = read_json(run.out);
  EXPECT_EQ(schema.value("$schema", ""), "http://json-schema.org/draft-07/schema#");
}

TEST(command_line, new_writes_a_model_that_is_valid) {
  for (const char* words : {"--pipe 4 --depth '10 m'", "--pipe '12 in' --depth '500 ft'",
                            "--pipe '508 mm' --depth '89 m'", "--pipe 16 --depth '1200 m' --lay j"}) {
    const ProgramRun run = run_program(std::string("new ") + words);
    ASSERT_EQ(run.code, 0) << words << "\n" << run.err;
    const ModelReading reading = read_model_text(run.out, "new.yaml");
    EXPECT_TRUE(reading.description.has_value()) << words;
    for (const Diagnostic& d : reading.diagnostics.sorted()) ADD_FAILURE() << words << ": " << render(d);
  }
}

TEST(command_line, new_does_not_wait_for_answers_where_nobody_sits) {
  const ProgramRun run = run_program("new < /dev/zero");  // never ends, and is no terminal
  EXPECT_EQ(run.code, 2);
  EXPECT_NE(run.err.find("--pipe is missing"), std::string::npos);
}

TEST(command_line, new_takes_what_it_is_told) {
  const ProgramRun run = run_program(
      "new --pipe 16 --depth '89 m' --wall '0.5 in' --concrete '50 mm' --tension '300 kN' --stinger-radius '150 m' "
      "--boxes 6 --vessel ship --yield '65 ksi' --title 'my lay'");
  const auto d = read_model_text(run.out, "new.yaml").description;
  ASSERT_TRUE(d.has_value()) << run.err;
  EXPECT_EQ(d->title, "my lay");
  EXPECT_NEAR(d->pipe.section.steel.wall_thickness, 0.0127, 1e-9);
  EXPECT_NEAR(d->pipe.section.steel.yield_stress, 448.159e6, 1e3);
  EXPECT_NEAR(d->pipe.section.coatings.at(1).thickness, 0.05, 1e-9);
  EXPECT_DOUBLE_EQ(d->tensioner.tension.value_or(0.0), 300e3);
  EXPECT_DOUBLE_EQ(d->supports.stinger_radius.value_or(0.0), 150.0);
  EXPECT_EQ(std::count_if(d->supports.boxes.begin(), d->supports.boxes.end(),
                          [](const BoxDescription& box) { return box.structure == Structure::stinger; }),
            6);
  EXPECT_EQ(d->vessel.name, "ship");
}

TEST(command_line, new_refuses_what_can_not_be) {
  for (const char* words :
       {"--pipe 16", "--depth '89 m'", "--pipe 17 --depth '89 m'", "--pipe 16 --depth 89", "--pipe 16 --depth '89 kN'",
        "--pipe 16 --depth '89 m' --tension '1 kN'", "--pipe 16 --depth '89 m' --boxes 90",
        "--pipe 16 --depth '89 m' --wall '300 mm'", "--pipe 16 --depth '89 m' --wall '3 mm' --concrete '0 mm'"}) {
    const ProgramRun run = run_program(std::string("new ") + words);
    EXPECT_EQ(run.code, 2) << words;
    EXPECT_EQ(run.out, "") << words;
    EXPECT_EQ(run.err.rfind("overbend new: ", 0), 0U) << words << ": " << run.err;
  }
}

TEST(command_line, new_never_overwrites_unasked) {
  const Scratch scratch;
  const std::string file = scratch.write("mine.yaml", "precious");
  const std::string words = "new --pipe 16 --depth '89 m' -o " + file;
  EXPECT_EQ(run_program(words).code, 2);
  EXPECT_EQ(scratch.read("mine.yaml"), "precious");
  EXPECT_EQ(run_program(words + " --force").code, 0);
  EXPECT_EQ(scratch.read("mine.yaml").rfind("# 406.4 mm pipe", 0), 0U);
}

std::string text_of(const std::string& path) {
  std::ifstream in(path);
  return {std::istreambuf_iterator<char>(in), {}};
}

TEST(command_line, check_shows_places_and_inclines_of_supports_in_one_frame) {
  const testing::Scratch scratch;
  std::string text = text_of(example("first-model.yaml"));
  text.replace(text.find("vessel:\n"), 8, "vessel:\n  trim: 1 deg\n");
  const ProgramRun run = run_program("check " + scratch.write("trim.yaml", text));
  ASSERT_EQ(run.code, 0) << run.err;
  const std::size_t line = run.out.find("  ramp 1 ");
  ASSERT_NE(line, std::string::npos);
  const std::string row = run.out.substr(line, run.out.find('\n', line) - line);
  for (const char* value : {"-35.083", "4.458", "4.86"}) EXPECT_NE(row.find(value), std::string::npos) << row;
}

TEST(command_line, check_says_what_static_warns_of_without_a_solution) {
  const testing::Scratch scratch;
  std::string text = text_of(example("first-model.yaml"));
  text.replace(text.find("z: -11.12 m"), 11, "z: 11.12 m");
  const std::string file = scratch.write("sign.yaml", text);
  const std::string words = "the box 'stinger 3' is 20.46 m above the line through its neighbours";
  const ProgramRun checked = run_program("check " + file);
  EXPECT_EQ(checked.code, 0);
  EXPECT_NE(checked.out.find(words), std::string::npos) << checked.out;
  const ProgramRun solved = run_program("static " + file + " -o " + scratch.file("out"));
  EXPECT_EQ(solved.code, 3);
  EXPECT_NE(solved.err.find(words), std::string::npos) << solved.err;
}

}  // namespace
}  // namespace overbend
