/// The program's import of OrcaFlex files, as a user runs it: import, then solve.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <regex>

#include "base/json.h"
#include "program.h"

namespace overbend {
namespace {

using testing::run_program;
using testing::Scratch;

std::string reference_case(const std::string& name) {
  return std::string(OVERBEND_SOURCE_DIR) + "/validation/orcaflex_cases/" + name;
}

/// Statics of a model file.
Json statics(const Scratch& scratch, const std::string& model, const std::string& folder) {
  const auto run = run_program("static " + model + " -o " + scratch.file(folder));
  EXPECT_EQ(run.code, 0) << model << ": " << run.err;
  return read_json(scratch.read(folder + "/summary.json")).at("static");
}

/// Numbers that differ by more than 1e-6 of their value and 1e-3 of their unit (1e-3 N, 1e-3 m).
void compare(const Json& ours, const Json& theirs, const std::string& path, std::string& differences) {
  static const std::regex kOfTheRun("wall_time|iterations|residual|imbalance|history");
  if (std::regex_search(path, kOfTheRun)) return;
  if (theirs.is_object()) {
    for (const auto& [key, value] : theirs.items()) {
      ours.contains(key) ? compare(ours.at(key), value, path + "/" + key, differences)
                         : void(differences += path + "/" + key + " is missing\n");
    }
  } else if (theirs.is_array()) {
    if (ours.size() != theirs.size()) differences += path + " has another length\n";
    for (std::size_t i = 0; i < std::min(ours.size(), theirs.size()); ++i) {
      compare(ours[i], theirs[i], path + "/" + std::to_string(i), differences);
    }
  } else if (theirs.is_number_float()) {
    const double a = ours.get<double>(), b = theirs.get<double>();
    if (std::abs(a - b) > std::max(1e-3, 1e-6 * std::abs(b))) {
      differences += path + ": " + std::to_string(a) + ", " + std::to_string(b) + "\n";
    }
  }
}

class ImportedCase : public ::testing::TestWithParam<const char*> {};

TEST_P(ImportedCase, solves_to_the_results_of_the_model_written_by_hand) {
  const Scratch scratch;
  const std::string name = GetParam();
  const std::string model = scratch.file("model.yaml");
  const auto imported = run_program("import " + reference_case(name + ".yml") + " -o " + model);
  ASSERT_EQ(imported.code, 0) << imported.err;
  EXPECT_EQ(imported.out, scratch.read("model.account.txt"));
  std::string differences;
  compare(statics(scratch, model, "ours"), statics(scratch, reference_case(name + ".equivalent.yaml"), "theirs"), "",
          differences);
  EXPECT_EQ(differences, "");
}

INSTANTIATE_TEST_SUITE_P(import_command, ImportedCase,
                         ::testing::Values("slay-simple", "slay-explicit", "jlay-coated", "slay-user-units",
                                           "moored-chain-wire", "jumper-general", "slay-winch", "slay-two-seas"));

class ExportedExample : public ::testing::TestWithParam<const char*> {};

TEST_P(ExportedExample, solves_to_the_same_lay_after_it_is_imported_again) {
  const Scratch scratch;
  const std::string model = testing::example(GetParam());
  const auto exported = run_program("export --orcaflex " + model + " -o " + scratch.file("lay.yml"));
  ASSERT_EQ(exported.code, 0) << exported.err;
  EXPECT_EQ(exported.out, scratch.read("lay.account.txt"));
  ASSERT_EQ(run_program("import " + scratch.file("lay.yml") + " -o " + scratch.file("again.yaml")).code, 0);
  const Json again = statics(scratch, scratch.file("again.yaml"), "again"), first = statics(scratch, model, "first");
  for (const char* key : {"top_tension", "bottom_tension", "top_to_touchdown", "length_top_to_touchdown"}) {
    EXPECT_NEAR(again.at(key).get<double>() / first.at(key).get<double>(), 1.0, 1e-6) << key;
  }
  const auto stress = [](const Json& lay) { return lay.at("sagbend").at("max_bending_stress").get<double>(); };
  EXPECT_NEAR(stress(again) / stress(first), 1.0, 1e-6);
}

INSTANTIATE_TEST_SUITE_P(export_command, ExportedExample, ::testing::Values("shallow-s-lay.yaml", "first-model.yaml"));

TEST(import_command, of_a_lay_gives_the_top_tension_of_the_reference) {
  const Scratch scratch;
  const std::string model = scratch.file("model.yaml");
  ASSERT_EQ(run_program("import " + reference_case("slay-simple.yml") + " -o " + model).code, 0);
  const Json ours = statics(scratch, model, "out");
  EXPECT_NEAR(ours.at("top_tension").get<double>(), 224998.53867170805, 0.3);
  // The file has no yield stress.
  const Json findings = read_json(scratch.read("out/summary.json")).at("findings");
  EXPECT_TRUE(std::any_of(findings.begin(), findings.end(),
                          [](const Json& finding) { return finding.at("code") == "yield-assumed"; }));
}

TEST(import_command, of_supports_along_a_path_lays_the_pipe_at_its_radius) {
  const Scratch scratch;
  const std::string model = scratch.file("model.yaml");
  ASSERT_EQ(run_program("import " + reference_case("stinger-shape.yml") + " -o " + model).code, 0);
  const Json ours = statics(scratch, model, "out");
  // Radius of the path, offset of the supports, radius of their cylinders.
  EXPECT_NEAR(ours.at("stinger_fitted_radius").get<double>(), 150.0 + 1.0 + 0.2, 1e-6);
  EXPECT_GT(ours.at("bottom_tension").get<double>(), 0.0);
}

TEST(import_command, never_overwrites_unasked_and_takes_a_yield_stress) {
  const Scratch scratch;
  const std::string model = scratch.write("model.yaml", "mine");
  const std::string command = "import " + reference_case("slay-simple.yml") + " -o " + model;
  const auto rejected = run_program(command);
  EXPECT_EQ(rejected.code, 2);
  EXPECT_NE(rejected.err.find("--force"), std::string::npos) << rejected.err;
  EXPECT_EQ(scratch.read("model.yaml"), "mine");
  ASSERT_EQ(run_program(command + " --force --yield '450 MPa'").code, 0);
  EXPECT_NE(scratch.read("model.yaml").find("yield_stress: 450 MPa"), std::string::npos);
  EXPECT_EQ(scratch.read("model.yaml").find("yield_assumed"), std::string::npos);
  EXPECT_EQ(run_program(command + " --force --yield '450 m'").code, 2);
}

TEST(import_command, strict_ends_with_4_where_something_that_matters_is_left_out) {
  const Scratch scratch;
  const std::string whole = reference_case("jlay-coated.yml");
  EXPECT_EQ(run_program("import " + whole + " --strict -o " + scratch.file("whole.yaml")).code, 0);
  std::ifstream in(whole);
  std::stringstream text;
  text << in.rdbuf();
  const std::string file = scratch.write(
      "buoy.yml", std::regex_replace(text.str(), std::regex("\nLines:"), "\n6DBuoys:\n  - Name: Sled\nLines:"));
  const auto run = run_program("import " + file + " --strict -o " + scratch.file("buoy.yaml"));
  EXPECT_EQ(run.code, 4) << run.err;
  EXPECT_NE(run.out.find("6DBuoys Sled"), std::string::npos) << run.out;
}

}  // namespace
}  // namespace overbend
