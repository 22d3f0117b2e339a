#include "modelfile/binding/tolerances.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "modelfile/reading/yaml_reader.h"
#include "support/solved_case.h"

namespace overbend {
namespace {

std::string model_with(const std::string& tolerances) {
  return testing::file_text(OVERBEND_SOURCE_DIR "/examples/bgl1.yaml") + "\nsensitivities:\n  tolerances:\n" +
         tolerances;
}

ModelReading read_tolerances(const std::string& tolerances) {
  return read_model_text(model_with(tolerances), OVERBEND_SOURCE_DIR "/examples/bgl1.yaml");
}

InputTolerance find_tolerance(const std::string& tolerances, const std::string& key) {
  const ModelValues values(read_tolerances(tolerances).description.value());
  return input_tolerances(values.root(), values.inputs()).at(values.find(key).value());
}

std::string complaint_about(const std::string& tolerances) {
  const std::vector<std::string> lines = read_tolerances(tolerances).diagnostics.lines(Severity::error);
  return lines.size() == 1 ? lines.front() : "not one error but " + std::to_string(lines.size());
}

TEST(tolerances, of_a_pattern_hold_for_every_key_it_matches_and_the_last_counts) {
  const std::string file =
      "    supports.*.boxes[*].z: 20 mm\n    supports.stinger.boxes[stinger 3].z: 5 mm\n    tensioner.tension: 4 %\n";
  EXPECT_DOUBLE_EQ(find_tolerance(file, "supports.ramp.boxes[0].z").value, 0.02);
  EXPECT_DOUBLE_EQ(find_tolerance(file, "supports.stinger.boxes[2].z").value, 0.005);
  EXPECT_DOUBLE_EQ(find_tolerance(file, "tensioner.tension").value, 10e3);
  EXPECT_TRUE(find_tolerance(file, "tensioner.tension").given);
}

TEST(tolerances, that_are_not_given_are_the_usual_ones_and_say_so) {
  const std::string file = "    tensioner.tension: 4 %\n";
  EXPECT_DOUBLE_EQ(find_tolerance(file, "supports.ramp.boxes[0].z").value, 0.01);
  EXPECT_DOUBLE_EQ(find_tolerance(file, "environment.water_depth").value, 0.89);
  EXPECT_NEAR(find_tolerance(file, "vessel.heading").value, 0.1 * 3.14159265358979 / 180.0, 1e-12);
  EXPECT_FALSE(find_tolerance(file, "vessel.heading").given);
}

TEST(tolerances, of_an_unknown_key_or_another_dimension_are_one_error) {
  EXPECT_NE(complaint_about("    tensioner.tensoin: 4 %\n").find("did you mean 'tensioner.tension'?"),
            std::string::npos)
      << complaint_about("    tensioner.tensoin: 4 %\n");
  EXPECT_NE(complaint_about("    tensioner.tension: 20 mm\n").find("a force"), std::string::npos);
  EXPECT_NE(complaint_about("    supports.*.boxes[*].z: -20 mm\n").find("not negative"), std::string::npos);
}

}  // namespace
}  // namespace overbend
