#include "study/sensitivity/sensitivities.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "checks/run_checks.h"
#include "modelfile/binding/model_inputs.h"
#include "modelfile/reading/yaml_reader.h"
#include "modelfile/yaml/yaml_edit.h"
#include "statics/recovery/recovery.h"
#include "study/sensitivity/result_values.h"

namespace overbend {
namespace {

/// A lay solved as well as doubles let it.
struct Lay {
  Model model;
  StaticSolution solution;
};

Lay solved(Description description) {
  description.statics.tolerance = 1e-11;
  Model model = build_model(description);
  StaticSolution solution = solve_statics(model).solution.value();
  return {std::move(model), std::move(solution)};
}

Lay solved_file(const std::string& file) {
  return solved(read_model(OVERBEND_SOURCE_DIR + file).description.value());
}

/// A lay whose checks take the current as functional, so that they depend on one equilibrium alone.
Lay lay_without_still_water(const std::string& file) {
  const std::string path = OVERBEND_SOURCE_DIR + file;
  const Description description = read_model(path).description.value();
  const std::string text =
      edit_yaml(description.source_text, {{"checks.current_load", YamlChange::Kind::scalar, "functional"}});
  return solved(read_model_text(text, path).description.value());
}

std::vector<ResultValue> collect_values(const Model& model, const StaticSolution& solution) {
  StaticResults results = recover_statics(model, solution);
  fill_checks(model, results);
  return result_values(results);
}

/// Results of the full equations with another value of a key, from the solution and on its mesh.
std::vector<ResultValue> solved_with(const Lay& lay, const std::string& key, double value) {
  ModelValues values(lay.model.description);
  Description description = values.with(values.inputs().at(values.find(key).value()), value);
  description.statics.tolerance = lay.model.description.statics.tolerance;
  const Model model = build_model(description);
  const StaticSolution solution = solve_statics(model, &lay.solution).solution.value();
  EXPECT_EQ(solution.mesh.s.size(), lay.solution.mesh.s.size()) << "the mesh has to be the same";
  return collect_values(model, solution);
}

/// Tolerance of a result between two solves that end at 1e-11 of the line's weight, which is 20 N/1e6.
double max_noise(const SensitivityOutput& result) {
  const double min_value = result.unit == "N" ? 2e-5 : result.unit == "m" ? 1e-9 : 1e-11;
  return std::max(2e-11 * std::abs(result.value), min_value);
}

/// An input, and the step of the full solves either way: wide enough to stand out of their noise, and too short for a
/// contact to change.
struct Trial {
  std::string key;
  double step;
  double relative = 1e-5;  ///< To what they agree.
  double noisier = 1.0;    ///< Times as much noise in the full solves.
};

/// Compares with central differences of full solves, wherever these say as much; returns how many do.
int compare(const Lay& lay, const SensitivityResults& found, const Trial& trial) {
  const auto input = std::ranges::find(found.inputs, trial.key, &SensitivityInput::name);
  EXPECT_NE(input, found.inputs.end()) << trial.key;
  if (input == found.inputs.end()) return 0;
  const std::vector<ResultValue> low = solved_with(lay, trial.key, input->value - trial.step),
                                 high = solved_with(lay, trial.key, input->value + trial.step);
  int compared = 0;
  for (std::size_t r = 0; r < found.results.size(); ++r) {
    const double full = (high[r].value - low[r].value) / (2.0 * trial.step);
    const double slope = found.at(r, static_cast<std::size_t>(input - found.inputs.begin())).value;
    const double noise = trial.noisier * max_noise(found.results[r]) / trial.step;
    EXPECT_NEAR(slope, full, trial.relative * std::abs(full) + noise) << found.results[r].name << " by " << trial.key;
    if (trial.relative * std::abs(full) > noise) ++compared;
  }
  return compared;
}

int compare(const Lay& lay, const std::vector<Trial>& trials) {
  const SensitivityResults found = find_sensitivities(lay.model, lay.solution).value();
  EXPECT_TRUE(found.not_done.empty());
  int compared = 0;
  for (const Trial& trial : trials) compared += compare(lay, found, trial);
  return compared;
}

TEST(sensitivities, of_bgl1_are_those_of_full_solves) {
  const int compared =
      compare(lay_without_still_water("/examples/bgl1.yaml"), {{"tensioner.tension", 5.0},
                                                               {"environment.water_depth", 1e-4},
                                                               {"pipe.coatings[concrete].weight_density", 0.2},
                                                               {"pipe.steel.youngs_modulus", 2e6},
                                                               {"pipe.steel.wall_thickness", 1e-7},
                                                               {"tensioner.x", 1e-5},
                                                               {"vessel.stern_shoe.z", 1e-5},
                                                               {"supports.ramp.boxes[ramp 4].z", 1e-5},
                                                               {"supports.stinger.boxes[stinger 3].z", 1e-5},
                                                               {"supports.stinger.boxes[stinger 8].x", 1e-5},
                                                               {"environment.current[0].speed", 1e-5},
                                                               {"environment.seabed.stiffness", 10.0}});
  EXPECT_GT(compared, 80);  // the others stand out of the noise by less than 1e-5
}

TEST(sensitivities, of_checks_follow_the_lay_in_still_water_too) {
  const Lay lay = solved_file("/examples/bgl1.yaml");
  const SensitivityResults found = find_sensitivities(lay.model, lay.solution, {{"tensioner.tension"}, false}).value();
  EXPECT_GT(compare(lay, found, {"tensioner.tension", 10.0, 1e-5, 3.0}), 15);  // three: of what stands at touchdown
}

TEST(sensitivities, of_a_j_lay_are_those_of_full_solves) {
  // Utilisations at touchdown have the noise of its place, which is that of heights over the small slope there.
  const int compared = compare(
      solved_file("/validation/static_cases/J12-D400-T560.yaml"),
      {{"tensioner.tension", 5.0}, {"environment.water_depth", 1e-4}, {"pipe.steel.wall_thickness", 1e-7, 1e-5, 12.0}});
  EXPECT_GT(compared, 15);
}

TEST(sensitivities, know_what_yielding_steel_remembers) {
  const Lay lay = solved_file("/examples/bgl1-as-printed-steel.yaml");
  // The exact tangent is itself a difference here, over 0.01 mm, and the full solves converge linearly.
  const std::vector<Trial> trials = {{"tensioner.tension", 5.0, 3e-3, 10.0},
                                     {"supports.stinger.boxes[stinger 3].z", 1e-5, 3e-3, 10.0}};
  const SensitivityResults found =
      find_sensitivities(lay.model, lay.solution, {{trials[0].key, trials[1].key}, false}).value();
  int compared = 0;
  for (const Trial& trial : trials) compared += compare(lay, found, trial);
  EXPECT_GT(compared, 40);
}

TEST(sensitivities, are_one_sided_where_a_contact_changes_within_the_tolerance) {
  const Lay lay = lay_without_still_water("/examples/bgl1.yaml");
  const std::string key = "supports.stinger.boxes[stinger 2].z";
  const SensitivityResults found = find_sensitivities(lay.model, lay.solution, {{key}, true}).value();
  const auto result = std::ranges::find(found.results, "static.supports[stinger 1].reaction", &SensitivityOutput::name);
  const auto r = static_cast<std::size_t>(result - found.results.begin());
  const Derivative& slope = found.at(r, 0);
  ASSERT_EQ(slope.support, "stinger 2");
  EXPECT_TRUE(slope.closes);
  EXPECT_EQ(found.inputs[0].near.front(), "stinger 2");
  // Full solves on either side of where it is said to close; the response itself bends by 1e-4 on the way.
  const auto full = [&](double position) {
    return (solved_with(lay, key, position + 2e-5)[r].value - solved_with(lay, key, position - 2e-5)[r].value) / 4e-5;
  };
  EXPECT_NEAR(full(slope.until - 1e-4), slope.value, 3e-4 * std::abs(slope.value));
  EXPECT_NEAR(full(slope.until + 1e-4), slope.beyond, 3e-4 * std::abs(slope.beyond));
  EXPECT_GT(std::abs(slope.beyond), 4.0 * std::abs(slope.value));
}

TEST(sensitivities, as_a_jacobian_stand_in_the_order_asked_for) {
  const Lay lay = solved_file("/validation/static_cases/J12-D400-T560.yaml");
  const std::vector<std::string> results = {"static.lay_back", "static.bottom_tension"};
  const std::vector<std::string> keys = {"environment.water_depth", "tensioner.tension"};
  const std::vector<double> rows = jacobian(lay.model, lay.solution, results, keys).value();
  ASSERT_EQ(rows.size(), 4U);
  EXPECT_NEAR(rows[3], 1.0, 1e-2);  // what is pulled more at the top is pulled more at the bottom
  EXPECT_LT(rows[2], -100.0);       // and what hangs longer, less
  EXPECT_FALSE(jacobian(lay.model, lay.solution, {"static.nothing"}, keys));
  EXPECT_FALSE(jacobian(lay.model, lay.solution, results, {"tensioner.nothing"}));
}

TEST(sensitivities, name_what_no_result_depends_on) {
  const Lay lay = solved_file("/validation/static_cases/J12-D400-T560.yaml");
  const SensitivityResults found = find_sensitivities(lay.model, lay.solution).value();
  const auto idle = [&](const char* key) { return std::ranges::count(found.without_effect, key) == 1; };
  EXPECT_TRUE(idle("vessel.length"));
  EXPECT_FALSE(idle("tensioner.tension"));
}

}  // namespace
}  // namespace overbend
