// The numbers to expect that the pages of examples/ state, as a user would compare them: to the digits printed there.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>

#include "app/commands.h"
#include "recording/run_dynamics.h"
#include "study/run/static_analysis.h"
#include "support/memory_sink.h"

namespace overbend {
namespace {

struct Expected {
  const char* file;
  double bottom_tension_kN, lay_back_m, overbend_stress_MPa, sagbend_stress_MPa;
};

// Half a unit of the last printed digit, and as much again for another compiler's rounding of the mesh.
constexpr double kTenth = 0.1, kWhole = 1.0;

Description example(const std::string& name) {
  const std::optional<Description> description = load_model(std::string(OVERBEND_SOURCE_DIR) + "/examples/" + name);
  if (!description) {
    throw std::runtime_error(name + " is not a valid model");
  }
  return *description;
}

StaticResults solved(const Description& description) {
  const Model model = build_model(description);
  const StaticOutcome outcome = solve_statics(model);
  if (!outcome.solution) {
    throw std::runtime_error(description.title + ": " + outcome.failure->what);
  }
  return checked_statics(model, {outcome.solution, {}, {}});
}

/// A run as the pages' column of one minute has it: 60 s after the build-up, which is the file's own if not given.
DynamicResults run_one_minute(Description description, std::optional<double> build_up = {}) {
  description.dynamics->duration = 60.0;
  description.dynamics->build_up = build_up.value_or(description.dynamics->build_up);
  const Model model = build_model(description);
  const StaticSolution start = solve_statics(model).solution.value();
  const StaticResults statics = checked_statics(model, {start, {}, {}});
  testing::MemorySink sink;
  const DynamicOutcome outcome = run_dynamics(model, start, statics, dynamic_options(model), sink, nullptr,
                                              [](const DynamicProgress&) { return DynamicControl::go_on; });
  return outcome.results.value();
}

const SupportResult& box(const StaticResults& results, const std::string& name) {
  return *std::find_if(results.supports.begin(), results.supports.end(), [&](const auto& b) { return b.name == name; });
}

int carrying_boxes(const StaticResults& results) {
  return static_cast<int>(
      std::count_if(results.supports.begin(), results.supports.end(), [](const auto& b) { return b.reaction > 0.0; }));
}

TEST(examples, give_the_numbers_that_their_page_states) {
  constexpr Expected kExpected[] = {
      {"first-model.yaml", 258.1, 178.4, 325.0, 97.0},
      {"bgl1.yaml", 205.5, 335.6, 312.0, 74.0},
      {"bgl1-as-printed.yaml", 205.5, 334.5, 528.0, 74.0},
      {"bgl1-workable-sea.yaml", 205.5, 335.1, 312.0, 74.0},
      {"bgl1-as-printed-steel.yaml", 207.6, 335.8, 395.0, 203.0},
  };
  for (const Expected& expected : kExpected) {
    SCOPED_TRACE(expected.file);
    const StaticResults results = solved(example(expected.file));
    EXPECT_NEAR(1e-3 * results.bottom_tension, expected.bottom_tension_kN, kTenth);
    EXPECT_NEAR(results.lay_back, expected.lay_back_m, kTenth);
    ASSERT_TRUE(results.overbend);
    EXPECT_NEAR(1e-6 * results.overbend->bending_stress.value, expected.overbend_stress_MPa, kWhole);
    EXPECT_NEAR(1e-6 * results.sagbend.bending_stress.value, expected.sagbend_stress_MPa, kWhole);
  }
}

TEST(examples, first_model_leaves_its_stinger_at_the_last_but_one_box) {
  const StaticResults results = solved(example("first-model.yaml"));
  EXPECT_EQ(results.last_support, "stinger 2");
  EXPECT_NEAR(*results.stinger_tip_clearance, 0.051, 0.005);
}

TEST(examples, static_page_holds) {
  const StaticResults r = solved(example("bgl1.yaml"));
  EXPECT_NEAR(1e-6 * r.overbend->von_mises.value, 330.0, kWhole);
  EXPECT_NEAR(1e-6 * r.sagbend.von_mises.value, 90.0, kWhole);
  EXPECT_NEAR(*r.stinger_tip_clearance, 0.29, 0.02);
  EXPECT_EQ(r.max_reaction_support, "ramp 1");
  EXPECT_NEAR(1e-3 * r.max_reaction, 47.8, 1.0);  // a millimetre of roller height is worth kilonewtons
  EXPECT_EQ(carrying_boxes(r), 9);
  // The forces that carry the lay are its weight: nothing is lost on the way.
  EXPECT_LT(r.global_residual, 1e-9);
  // Over frictionless rollers the tension falls by the weight of pipe as long as the way is deep: 5.222 m in
  // air, 88.756 m in water, for any shape. The addition of bending at the tensioner is below 0.1 kN.
  EXPECT_NEAR(1e-3 * (r.top_tension - r.bottom_tension), 2.2559 * 5.222 + 0.36849 * 88.756, kTenth);
}

TEST(examples, stinger_as_printed_loads_one_box_and_passes_yield) {
  const StaticResults r = solved(example("bgl1-as-printed.yaml"));
  EXPECT_NEAR(1e-6 * r.overbend->von_mises.value, 545.0, kWhole);
  EXPECT_NEAR(1e-3 * box(r, "stinger 2").reaction, 111.0, 2.0);
  EXPECT_NEAR(1e-3 * r.max_reaction, 68.3, 1.0);
  EXPECT_EQ(r.max_reaction_support, "stinger 2");
  EXPECT_EQ(carrying_boxes(r), 6);
  const StaticResults mended = solved(example("bgl1.yaml"));
  EXPECT_GT(carrying_boxes(mended), carrying_boxes(r));
  // The sagbend does not see the table: its stress follows from tension, weight and depth.
  EXPECT_NEAR(r.sagbend.bending_stress.value / mended.sagbend.bending_stress.value, 1.0, 0.005);
}

TEST(examples, yielding_page_holds) {
  const StaticResults linear = solved(example("bgl1-as-printed.yaml")),
                      steel = solved(example("bgl1-as-printed-steel.yaml"));
  EXPECT_NEAR(1e-3 * linear.overbend->bending_moment.value, 704.0, 2.0);
  EXPECT_NEAR(1e-3 * steel.overbend->bending_moment.value, 616.0, 2.0);
  EXPECT_NEAR(1e2 * linear.overbend->strain.value, 0.264, 0.002);
  EXPECT_NEAR(1e2 * steel.overbend->strain.value, 0.303, 0.002);
  EXPECT_NEAR(steel.residual_curvature, 0.0031, 1e-4);
  const auto says_roll = [](const std::string& warning) { return warning.find("rolls") != std::string::npos; };
  EXPECT_TRUE(std::ranges::any_of(messages(steel.findings), says_roll));
  EXPECT_FALSE(std::ranges::any_of(messages(linear.findings), says_roll));
  EXPECT_NEAR(1e-3 * linear.sagbend.bending_moment.value, 98.0, 1.0);
  EXPECT_NEAR(1e-3 * steel.sagbend.bending_moment.value, 269.0, 4.0);
  EXPECT_NEAR(1e-3 * steel.max_reaction, 76.1, 1.0);
  const auto criterion = [](const StaticResults& r) {
    return std::find_if(
               r.checks.rows.begin(), r.checks.rows.end(),
               [](const CheckRow& row) { return row.id == "dnv_criterion_1" && row.region == CheckRegion::overbend; })
        ->utilisation;
  };
  EXPECT_NEAR(criterion(linear), 1.15, 0.01);
  EXPECT_NEAR(criterion(steel), 1.32, 0.01);
}

TEST(examples, workable_sea_keeps_the_pipe_between_its_rollers_and_below_yield) {
  const DynamicResults r = run_one_minute(example("bgl1-workable-sea.yaml"), 20.0);
  EXPECT_TRUE(r.findings.empty())
      << messages(r.findings).front();  // the pipe leaves no box, nothing yields, tension stays
  // One minute has some eight waves, so these are loose: the extremes of three hours are inside the page's ranges.
  EXPECT_GT(r.top_tension.min, 0.0);
  EXPECT_LT(r.top_tension.min, 0.9 * 250e3);  // a machine that waits, on a moving barge
  EXPECT_GT(r.top_tension.max, 1.1 * 250e3);
  EXPECT_LT(r.top_tension.max, 600e3);
  // The rollers hold the curvature of the overbend; what is added is what the tension's swing presses over them.
  EXPECT_GT(r.overbend.von_mises.over_time.max, 334e6);  // of statics
  EXPECT_LT(r.overbend.von_mises.over_time.max, 390e6);
  EXPECT_LT(r.sagbend.von_mises.over_time.max, 200e6);
  EXPECT_GT(r.stinger_tip_clearance.min, 0.0);
  EXPECT_LT(std::abs(r.energy.drift()), 1e-3);
}

// Rounding of the mesh is all that may be seen, in contacts that come and go as well.
TEST(examples, workable_sea_does_not_see_where_nodes_lie_over_the_rollers) {
  Description d = example("bgl1-workable-sea.yaml");
  d.mesh.overbend_element = 0.25;
  const DynamicResults fine = run_one_minute(d, 20.0);
  d.mesh.overbend_element = 1.0;
  const DynamicResults coarse = run_one_minute(d, 20.0);
  EXPECT_NEAR(coarse.overbend.bending_moment.over_time.max / fine.overbend.bending_moment.over_time.max, 1.0, 1e-3);
  EXPECT_NEAR(coarse.sagbend.bending_moment.over_time.max / fine.sagbend.bending_moment.over_time.max, 1.0, 1e-3);
  EXPECT_NEAR(coarse.top_tension.max / fine.top_tension.max, 1.0, 1e-3);
  EXPECT_NEAR(coarse.top_tension.min / fine.top_tension.min, 1.0, 1e-3);
}

bool left_over_its_side(const DynamicResults& r, const std::string& name) {
  return std::any_of(r.supports.begin(), r.supports.end(),
                     [&](const SupportDynamics& box) { return box.name == name && box.left_to_port; });
}

TEST(examples, irregular_sea_takes_the_pipe_off_its_stinger) {
  const DynamicResults r = run_one_minute(example("bgl1.yaml"));
  for (int k = 1; k <= 8; ++k) {
    EXPECT_TRUE(left_over_its_side(r, "stinger " + std::to_string(k))) << k;
  }
  EXPECT_EQ(std::ranges::count_if(messages(r.findings),
                                  [](const std::string& w) { return w.find("the pipe left '") != std::string::npos; }),
            1);
  // From here on the pipe moves next to its rollers, which rounding alone drives apart: only its kind is
  // stated.
  EXPECT_GT(r.overbend.von_mises.over_time.max, 800e6);  // twice the yield stress, of a steel that does not yield
  EXPECT_LT(r.stinger_tip_clearance.min, -3.0);
  EXPECT_LT(std::abs(r.energy.drift()), 1e-3);
}

// Tolerances of the pages' column of one minute: another compiler moves single impacts and turns of the machine.
constexpr double kTension = 1.0, kTime = 0.5, kTravel = 0.01, kStress = 2.0;

DynamicResults tensioner_study(TensionerMode mode) {
  Description description = example("bgl1-tensioner.yaml");
  description.tensioner.mode = mode;
  return run_one_minute(description);
}

TEST(examples, tensioner_page_holds) {
  const DynamicResults off = tensioner_study(TensionerMode::locked);
  const DynamicResults on = tensioner_study(TensionerMode::controlled);
  EXPECT_NEAR(1e-3 * off.tensioner.tension.std, 29.8, kTension);
  EXPECT_NEAR(1e-3 * off.tensioner.tension.min, 208.0, kTension);
  EXPECT_NEAR(1e-3 * off.tensioner.tension.max, 294.0, kTension);
  EXPECT_NEAR(off.tensioner.time_out_of_range, 52.9, kTime);  // 52.6 with steps of 20 ms, 52.7 of 5 ms
  EXPECT_NEAR(1e-3 * on.tensioner.tension.std, 20.6, kTension);
  EXPECT_NEAR(1e-3 * on.tensioner.tension.min, 195.0, kTension);
  EXPECT_NEAR(1e-3 * on.tensioner.tension.max, 292.8, kTension);
  EXPECT_NEAR(on.tensioner.time_out_of_range, 21.4, kTime);
  EXPECT_NEAR(on.tensioner.travel.min, 0.036, kTravel);
  EXPECT_NEAR(on.tensioner.travel.max, 0.186, kTravel);
  EXPECT_NEAR(1e-6 * on.overbend.von_mises.over_time.max, 334.0, kStress);
  EXPECT_TRUE(on.findings.empty());
  EXPECT_TRUE(off.findings.empty());
  // The machine shortens the time out of range more than it trims the peaks: both come while it still waits.
  EXPECT_LT(on.tensioner.time_out_of_range, 0.5 * off.tensioner.time_out_of_range);
  EXPECT_LT(on.tensioner.tension.min, off.tensioner.tension.min);
}

TEST(examples, ideal_constant_tension_travels_furthest_and_loses_the_pipe) {
  const DynamicResults r = tensioner_study(TensionerMode::constant);
  EXPECT_LT(r.tensioner.tension.std, 1e3);
  EXPECT_EQ(r.tensioner.time_out_of_range, 0.0);
  EXPECT_NEAR(r.tensioner.travel.min, -0.17, kTravel);
  EXPECT_NEAR(r.tensioner.travel.max, 0.18, kTravel);
  EXPECT_TRUE(left_over_its_side(r, "stinger 8"));
  EXPECT_GT(r.overbend.von_mises.over_time.max, 370e6);
}

struct Contacts {
  int places = 0, touched = 0;  ///< Rows of rollers, or springs; those that carried at some time.
  double peak = 0.0;            ///< Largest reaction of one of them [N].
};

Contacts count_row_contacts(const DynamicResults& r) {
  Contacts found;
  for (const SupportDynamics& support : r.supports) {
    for (int row = 0;; ++row) {
      bool present = false, touched = false;
      for (const RollerDynamics& roller : support.rollers) {
        if (roller.row == row) {
          present = true;
          touched = touched || roller.contact_share > 0.0;
          found.peak = std::max(found.peak, roller.reaction.max);
        }
      }
      if (!present) {
        break;
      }
      ++found.places;
      found.touched += touched ? 1 : 0;
    }
  }
  return found;
}

TEST(examples, contact_models_page_holds) {
  const DynamicResults rollers = run_one_minute(example("bgl1-tensioner.yaml"));
  Description traditional = example("bgl1-tensioner.yaml");
  traditional.supports.contact = SupportContact::gap_springs;
  const DynamicResults springs = run_one_minute(traditional);
  const Contacts rigorous = count_row_contacts(rollers), simple = count_row_contacts(springs);
  EXPECT_EQ(rigorous.places, 39);
  EXPECT_EQ(simple.places, 13);
  EXPECT_NEAR(rigorous.touched, 13, 1);
  EXPECT_NEAR(simple.touched, 11, 1);
  EXPECT_NEAR(1e-3 * rigorous.peak, 60.0, 2.0);
  EXPECT_NEAR(1e-3 * simple.peak, 55.0, 2.0);
  EXPECT_NEAR(1e-6 * springs.overbend.von_mises.over_time.max, 351.0, kStress);
  // A smaller share of the rollers touches, and one of them carries more than a third of a box's spring.
  EXPECT_LT(rigorous.touched * simple.places, simple.touched * rigorous.places);
  EXPECT_GT(rigorous.peak, simple.peak / 3.0);
}

}  // namespace
}  // namespace overbend
