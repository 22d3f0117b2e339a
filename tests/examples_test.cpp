// The numbers to expect that examples/README.md states, as a user would compare them: to the digits printed there.
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "analysis/dynamics.h"
#include "analysis/recovery.h"
#include "app/commands.h"
#include "support/memory_sink.h"

namespace overbend {
namespace {

struct Expected {
  const char* file;
  double bottom_tension_kN, lay_back_m, overbend_stress_MPa, sagbend_stress_MPa;
};

// Half a unit of the last printed digit, and as much again for another compiler's rounding of the mesh.
constexpr double kTenth = 0.1, kWhole = 1.0;

StaticResults solved(const std::string& name) {
  const std::optional<Description> description = load_model(std::string(OVERBEND_SOURCE_DIR) + "/examples/" + name);
  if (!description) {
    throw std::runtime_error(name + " is not a valid model");
  }
  const Model model = build_model(*description);
  const StaticOutcome outcome = solve_statics(model);
  if (!outcome.solution) {
    throw std::runtime_error(name + ": " + outcome.failure->what);
  }
  return recover_statics(model, *outcome.solution);
}

TEST(examples, give_the_numbers_that_their_page_states) {
  constexpr Expected kExpected[] = {
      {"first-model.yaml", 258.1, 178.4, 326.0, 97.0},
      {"bgl1.yaml", 205.5, 335.6, 316.0, 74.0},
      {"bgl1-as-printed.yaml", 205.5, 334.5, 530.0, 74.0},
      {"bgl1-workable-sea.yaml", 205.5, 335.1, 316.0, 74.0},
  };
  for (const Expected& expected : kExpected) {
    SCOPED_TRACE(expected.file);
    const StaticResults results = solved(expected.file);
    EXPECT_NEAR(1e-3 * results.bottom_tension, expected.bottom_tension_kN, kTenth);
    EXPECT_NEAR(results.lay_back, expected.lay_back_m, kTenth);
    ASSERT_TRUE(results.overbend);
    EXPECT_NEAR(1e-6 * results.overbend->bending_stress.value, expected.overbend_stress_MPa, kWhole);
    EXPECT_NEAR(1e-6 * results.sagbend.bending_stress.value, expected.sagbend_stress_MPa, kWhole);
  }
}

TEST(examples, first_model_leaves_its_stinger_at_the_last_but_one_box) {
  const StaticResults results = solved("first-model.yaml");
  EXPECT_EQ(results.last_support, "stinger 2");
  EXPECT_NEAR(*results.stinger_tip_clearance, 0.051, 0.005);
}

TEST(examples, workable_sea_keeps_the_pipe_between_its_rollers_and_below_yield) {
  Description description = load_model(std::string(OVERBEND_SOURCE_DIR) + "/examples/bgl1-workable-sea.yaml").value();
  description.dynamics->duration = 60.0;
  description.dynamics->build_up = 20.0;
  const Model model = build_model(description);
  const StaticSolution start = solve_statics(model).solution.value();
  const StaticResults statics = recover_statics(model, start);
  testing::MemorySink sink;
  const DynamicOutcome outcome = run_dynamics(model, start, statics, dynamic_options(model), sink, nullptr,
                                              [](const DynamicProgress&) { return DynamicControl::go_on; });
  ASSERT_TRUE(outcome.results);
  const DynamicResults& r = *outcome.results;
  EXPECT_TRUE(r.warnings.empty()) << r.warnings.front();  // the pipe leaves no box, nothing yields, tension stays
  // One minute has some eight waves, so these are loose: the extremes of three hours are inside the page's ranges.
  EXPECT_GT(r.top_tension.min, 0.0);
  EXPECT_LT(r.top_tension.min, 0.9 * 250e3);  // a locked brake on a moving barge
  EXPECT_GT(r.top_tension.max, 1.1 * 250e3);
  EXPECT_LT(r.top_tension.max, 600e3);
  // The rollers hold the curvature of the overbend; what is added is what the tension's swing presses over them.
  EXPECT_GT(r.overbend.von_mises.over_time.max, 334e6);  // of statics
  EXPECT_LT(r.overbend.von_mises.over_time.max, 390e6);
  EXPECT_LT(r.sagbend.von_mises.over_time.max, 200e6);
  EXPECT_GT(r.stinger_tip_clearance.min, 0.0);
  EXPECT_LT(std::abs(r.energy.drift()), 1e-3);
}

}  // namespace
}  // namespace overbend
