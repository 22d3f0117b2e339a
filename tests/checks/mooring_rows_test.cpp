#include "checks/mooring_rows.h"

#include <gtest/gtest.h>

namespace overbend {
namespace {

MooringLineResult line_with(const std::string& name, double tension, double use) {
  MooringLineResult line;
  line.name = name;
  line.fairlead_tension = line.anchor_tension = tension;
  line.utilisation = use;
  return line;
}

Description moored() {
  Description description;
  description.moorings.emplace();
  return description;
}

const CheckRow* find_check_row(const std::vector<CheckRow>& rows, const std::string& id) {
  for (const CheckRow& row : rows) {
    if (row.id == id) return &row;
  }
  return nullptr;
}

// API RP 2SK (2005), table of safety factors of mooring lines.
TEST(mooring_rows, factors_by_default_are_those_of_api_rp_2sk) {
  const SafetyFactors none;
  EXPECT_EQ(mooring_safety_factor(none, false, TensionAnalysis::quasi_static).value, 2.0);
  EXPECT_EQ(mooring_safety_factor(none, false, TensionAnalysis::dynamic).value, 1.67);
  EXPECT_EQ(mooring_safety_factor(none, true, TensionAnalysis::quasi_static).value, 1.43);
  EXPECT_EQ(mooring_safety_factor(none, true, TensionAnalysis::dynamic).value, 1.25);
}

TEST(mooring_rows, a_factor_of_the_model_takes_their_place_and_says_so) {
  SafetyFactors given;
  given.mooring_damaged = 1.1;
  const SafetyFactor factor = mooring_safety_factor(given, true, TensionAnalysis::dynamic);
  EXPECT_EQ(factor.value, 1.1);
  EXPECT_EQ(factor.source, "checks.safety_factors.mooring_damaged");
  EXPECT_EQ(mooring_safety_factor(given, false, TensionAnalysis::dynamic).value, 1.67);
  EXPECT_NE(cable_safety_factor({}).source.find("assumed"), std::string::npos);
}

TEST(mooring_rows, a_line_at_half_of_its_breaking_load_is_at_its_limit_in_statics) {
  MooringResults rest;
  rest.rest.name = "static";
  rest.rest.moorings = {line_with("bow", 1000e3, 0.5), line_with("stern", 800e3, 0.6)};
  const std::vector<CheckRow> rows = mooring_rows(moored(), rest, nullptr);
  const CheckRow* row = find_check_row(rows, "mooring_load");
  ASSERT_NE(row, nullptr);
  EXPECT_DOUBLE_EQ(row->utilisation, 1.2);  // 0.6 times 2
  EXPECT_EQ(row->status, CheckStatus::exceeded);
  EXPECT_NEAR(row->capacity, 800e3 / 0.6 / 2.0, 1e-6);
  EXPECT_NE(row->remark.find("stern, static"), std::string::npos) << row->remark;
  EXPECT_EQ(find_check_row(rows, "anchor_load"), nullptr);  // no holding power is given
}

TEST(mooring_rows, a_stage_with_a_missing_line_has_the_factor_of_the_damaged_state) {
  MooringResults rest;
  rest.rest.moorings = {line_with("bow", 500e3, 0.3)};
  MooredState stage;
  stage.name = "bow parted";
  stage.moorings = {line_with("bow", 0.0, 0.0), line_with("stern", 900e3, 0.6)};
  stage.moorings.front().parted = true;
  rest.stages = {stage};
  const std::vector<CheckRow> rows = mooring_rows(moored(), rest, nullptr);
  ASSERT_EQ(rows.size(), 1U);
  EXPECT_DOUBLE_EQ(rows.front().utilisation, 0.6 * 1.43);
  EXPECT_EQ(rows.front().status, CheckStatus::passed);
}

TEST(mooring_rows, in_time_lines_of_elements_have_the_dynamic_factor_and_quasi_static_lines_the_other) {
  DynamicResults run;
  MooringLineDynamics line;
  line.name = "bow";
  line.fairlead_tension.whole.max = line.intact_fairlead_tension = 600e3;
  line.utilisation = 0.55;
  run.moorings = {line};
  Description description = moored();
  EXPECT_NEAR(mooring_rows(description, {}, &run).front().utilisation, 0.55 * 1.67, 1e-12);
  description.moorings->model = MooringModel::quasi_static;
  EXPECT_NEAR(mooring_rows(description, {}, &run).front().utilisation, 0.55 * 2.0, 1e-12);
}

TEST(mooring_rows, a_run_in_which_a_line_parts_is_judged_by_both_factors_each_for_its_part_of_the_run) {
  DynamicResults run;
  MooringLineDynamics line;
  line.name = "stern";
  line.fairlead_tension.whole.max = 600e3;  // after the failure of the other
  line.intact_fairlead_tension = 540e3;
  line.utilisation = 0.6;
  run.moorings = {line, MooringLineDynamics{}};
  run.moorings.back().name = "bow";
  run.moorings.back().parted_at = 12.0;
  const Description description = moored();
  EXPECT_NEAR(mooring_rows(description, {}, &run).front().utilisation, 0.54 * 1.67, 1e-12);  // 0.6 * 1.25 is less
  run.moorings.front().intact_fairlead_tension = 400e3;
  EXPECT_NEAR(mooring_rows(description, {}, &run).front().utilisation, 0.6 * 1.25, 1e-12);
}

TEST(mooring_rows, the_working_load_and_the_anchor_have_rows_where_they_are_given) {
  Description description = moored();
  description.moorings->working_load = 500e3;
  MooringResults rest;
  rest.rest.moorings = {line_with("bow", 400e3, 0.2)};
  rest.rest.moorings.front().anchor_utilisation = 0.5;
  const std::vector<CheckRow> rows = mooring_rows(description, rest, nullptr);
  EXPECT_DOUBLE_EQ(find_check_row(rows, "mooring_working_load")->utilisation, 0.8);
  EXPECT_DOUBLE_EQ(find_check_row(rows, "anchor_load")->utilisation, 0.75);
}

}  // namespace
}  // namespace overbend
