#include <gtest/gtest.h>

#include <algorithm>

#include "app/program.h"
#include "base/json.h"
#include "model/vessel/fitted_circle.h"
#include "modelfile/reading/yaml_reader.h"

namespace overbend {
namespace {

using testing::example;
using testing::ProgramRun;
using testing::run_program;
using testing::Scratch;

TEST(command_line, help_and_version_succeed_on_standard_output) {
  for (const char* arguments : {"--help", "check --help", "new --help", "--version"}) {
    const ProgramRun run = run_program(arguments);
    EXPECT_EQ(run.code, 0) << arguments;
    EXPECT_FALSE(run.out.empty()) << arguments;
    EXPECT_EQ(run.err, "") << arguments;
  }
}

TEST(command_line, wrong_usage_is_wrong_input) {
  for (const char* arguments :
       {"", "nonsense", "check", "check a.yaml b.yaml", "--nonsense", "schema --nonsense", "new --boxes no"}) {
    const ProgramRun run = run_program(arguments);
    EXPECT_EQ(run.code, 2) << arguments;
    EXPECT_EQ(run.out, "") << arguments;
    EXPECT_FALSE(run.err.empty()) << arguments;
  }
}

/// Message of the program on arguments that it does not accept.
std::string said(const std::string& message) {
  const ProgramRun run = run_program(message);
  EXPECT_EQ(run.code, 2) << message;
  EXPECT_EQ(run.out, "") << message;
  EXPECT_EQ(std::ranges::count(run.err, '\n'), 1) << run.err;
  return run.err;
}

TEST(command_line, a_misspelt_option_is_named_with_the_one_that_was_meant) {
  EXPECT_EQ(said("static --outpt x model.yaml"),
            "overbend static: there is no option '--outpt'; did you mean '--output'?\n");
  EXPECT_EQ(said("dynamic model.yaml --chekpoint=20"),
            "overbend dynamic: there is no option '--chekpoint'; did you mean '--checkpoint'?\n");
  EXPECT_EQ(said("static --stric"), "overbend static: there is no option '--stric'; did you mean '--strict'?\n");
  EXPECT_NE(said("report -x results").find("there is no option '-x'; the options are -h"), std::string::npos);
  EXPECT_EQ(said("--strict static model.yaml"),
            "overbend: found '--strict' before the command 'static', expected options after it\n");
}

TEST(command_line, a_value_that_an_option_does_not_take_is_named_with_those_that_it_does) {
  EXPECT_EQ(said("new --vessel X --pipe 16 --depth '90 m'"),
            "overbend new: --vessel: found 'X', expected barge, BGL-1 or ship\n");
  EXPECT_EQ(said("new --vessel bgl1 --pipe 16 --depth '90 m'"),
            "overbend new: --vessel: found 'bgl1', expected barge, BGL-1 or ship; did you mean 'BGL-1'?\n");
  EXPECT_EQ(said("new --boxes 0"), "overbend new: --boxes: found '0', expected a whole number from 1 to 100\n");
  EXPECT_EQ(said("dynamic m.yaml --threads 1.5"),
            "overbend dynamic: --threads: found '1.5', expected a whole number from 1 to 4096\n");
  EXPECT_EQ(said("dynamic m.yaml --checkpoint nan"),
            "overbend dynamic: --checkpoint: found 'nan', expected a number of seconds of at least 0, without unit\n");
  EXPECT_EQ(said("study s.yaml --array-limit many"),
            "overbend study: --array-limit: found 'many', expected a whole number from 1 to 1000000\n");
  EXPECT_EQ(said("completion fish"), "overbend completion: FOR: found 'fish', expected bash, zsh or man\n");
  EXPECT_EQ(said("static m.yaml --units imperial"),
            "overbend static: --units: found 'imperial', expected metric or us\n");
  EXPECT_EQ(said("static m.yaml --strict=maybe"), "overbend static: --strict: found 'maybe', expected no value\n");
}

TEST(command_line, arguments_too_few_too_many_or_at_odds_are_named) {
  EXPECT_EQ(said("static"), "overbend static: MODEL is missing, expected: Model file (YAML)\n");
  EXPECT_EQ(said("static a.yaml b.yaml"), "overbend static: found 'b.yaml', expected only MODEL\n");
  EXPECT_EQ(said("licences now"), "overbend licences: found 'now', expected no positional argument\n");
  EXPECT_EQ(
      said("static m.yaml --stage").find("overbend static: --stage: the value is missing, expected: A single stage"),
      0U);
  EXPECT_EQ(said("static m.yaml -o a -o b"), "overbend static: --output: found it 2 times, expected it once\n");
  EXPECT_EQ(said("dynamic m.yaml --resume --restart").find("overbend dynamic: found --re"), 0U);
  EXPECT_EQ(said("").find("overbend: the command is missing; the commands are check, "), 0U);
  EXPECT_EQ(said("--fooo").find("overbend: there is no option '--fooo'; "), 0U);
}

TEST(command_line, a_size_between_those_of_api_5l_is_reported_with_its_neighbours) {
  EXPECT_EQ(
      said("new --pipe 31 --depth '90 m'"),
      "overbend new: --pipe: found '31', expected a nominal size [in], here 30 or 32, or an outside diameter with its "
      "unit, such as '406.4 mm'\n");
  EXPECT_NE(said("new --pipe 60 --depth '90 m'").find("here 48, or"), std::string::npos);
  EXPECT_NE(said("new --pipe 2 --depth '90 m'").find("here 4, or"), std::string::npos);
}

TEST(command_line, an_instruction_set_that_is_unknown_is_wrong_input) {
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
  const std::size_t index = run.out.find("  ramp 1 ");
  ASSERT_NE(index, std::string::npos);
  std::istringstream row(run.out.substr(index));
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
  for (const char* arguments : {"--pipe 4 --depth '10 m'", "--pipe '12 in' --depth '500 ft'",
                                "--pipe '508 mm' --depth '89 m'", "--pipe 16 --depth '1200 m' --lay j"}) {
    const ProgramRun run = run_program(std::string("new ") + arguments);
    ASSERT_EQ(run.code, 0) << arguments << "\n" << run.err;
    const ModelReading reading = read_model_text(run.out, "new.yaml");
    EXPECT_TRUE(reading.description.has_value()) << arguments;
    for (const Diagnostic& d : reading.diagnostics.sorted()) ADD_FAILURE() << arguments << ": " << render(d);
  }
}

TEST(command_line, new_does_not_wait_for_answers_without_a_terminal) {
  const ProgramRun run = run_program("new < /dev/zero");  // never ends, and is no terminal
  EXPECT_EQ(run.code, 2);
  EXPECT_NE(run.err.find("--pipe is missing"), std::string::npos);
}

TEST(command_line, new_takes_what_it_is_given) {
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
  EXPECT_FALSE(d->supports.stinger_radius.has_value());
  std::vector<Eigen::Vector2d> stinger;
  for (const BoxDescription& box : d->supports.boxes) {
    if (box.structure == Structure::stinger) stinger.emplace_back(box.x, box.z);
  }
  EXPECT_NEAR(fitted_radius(stinger).value_or(0.0), 150.0, 0.5);  // places to a millimetre
  EXPECT_EQ(std::count_if(d->supports.boxes.begin(), d->supports.boxes.end(),
                          [](const BoxDescription& box) { return box.structure == Structure::stinger; }),
            6);
  EXPECT_EQ(d->vessel.name, "ship");
}

TEST(command_line, new_rejects_what_can_not_be) {
  for (const char* arguments :
       {"--pipe 16", "--depth '89 m'", "--pipe 17 --depth '89 m'", "--pipe 16 --depth 89", "--pipe 16 --depth '89 kN'",
        "--pipe 16 --depth '89 m' --tension '1 kN'", "--pipe 16 --depth '89 m' --boxes 90",
        "--pipe 16 --depth '89 m' --wall '300 mm'", "--pipe 16 --depth '89 m' --wall '3 mm' --concrete '0 mm'"}) {
    const ProgramRun run = run_program(std::string("new ") + arguments);
    EXPECT_EQ(run.code, 2) << arguments;
    EXPECT_EQ(run.out, "") << arguments;
    EXPECT_EQ(run.err.rfind("overbend new: ", 0), 0U) << arguments << ": " << run.err;
  }
}

TEST(command_line, new_never_overwrites_unasked) {
  const Scratch scratch;
  const std::string file = scratch.write("mine.yaml", "precious");
  const std::string message = "new --pipe 16 --depth '89 m' -o " + file;
  EXPECT_EQ(run_program(message).code, 2);
  EXPECT_EQ(scratch.read("mine.yaml"), "precious");
  EXPECT_EQ(run_program(message + " --force").code, 0);
  EXPECT_EQ(scratch.read("mine.yaml").rfind("# 406.4 mm pipe", 0), 0U);
}

std::string load_text(const std::string& path) {
  std::ifstream in(path);
  return {std::istreambuf_iterator<char>(in), {}};
}

TEST(command_line, check_shows_places_and_inclines_of_supports_in_one_frame) {
  const testing::Scratch scratch;
  std::string text = load_text(example("first-model.yaml"));
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
  std::string text = load_text(example("first-model.yaml"));
  text.replace(text.find("z: -11.12 m"), 11, "z: 11.12 m");
  const std::string file = scratch.write("sign.yaml", text);
  const std::string message = "the box 'stinger 3' is 20.46 m above the line through its neighbours";
  const ProgramRun checked = run_program("check " + file);
  EXPECT_EQ(checked.code, 0);
  EXPECT_NE(checked.out.find(message), std::string::npos) << checked.out;
  const ProgramRun solved = run_program("static " + file + " -o " + scratch.file("out"));
  EXPECT_EQ(solved.code, 3);
  EXPECT_NE(solved.err.find(message), std::string::npos) << solved.err;
}

}  // namespace
}  // namespace overbend
