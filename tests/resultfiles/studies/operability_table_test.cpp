#include "resultfiles/studies/operability_table.h"

#include <gtest/gtest.h>

#include <numbers>

#include "resultfiles/studies/operability_json.h"
#include "resultfiles/tables/data_table.h"

namespace overbend {
namespace {

OperabilityResults chart() {
  OperabilityResults results;
  results.over = "environment.waves.hs";
  results.unit = results.show = "m";
  results.alpha = 0.8;
  StudyInput from;
  from.key = "environment.waves.from";
  from.unit = "rad";
  from.show = "deg";
  from.values = {0.0, std::numbers::pi / 2.0};
  StudyInput heading;
  heading.key = "tensioner.mode";
  heading.value_texts = {"locked", "constant"};
  results.axes = {from, heading};
  OperabilityCell found;
  found.value_indices = {1, 0};
  found.limit = 2.5;
  found.governing = "Roller force";
  found.below = 0.9;
  found.above = 1.1;
  found.runs = 7;
  OperabilityCell none = found, beyond = found, open = found;
  none.limit.reset();
  beyond.beyond = true;
  open.limit.reset();
  open.decided = false;
  open.reason = "interrupted";
  results.cells = {found, none, beyond, open};
  return results;
}

}  // namespace

TEST(operability_table, has_a_row_per_cell_in_the_units_of_the_study) {
  const Table table = operability_table(chart());
  const std::string text = csv_text(table);
  EXPECT_NE(text.find("environment.waves.from [deg]"), std::string::npos) << text;
  EXPECT_NE(text.find("largest environment.waves.hs [m]"), std::string::npos) << text;
  ASSERT_EQ(table.rows.size(), 4U);
  for (const TableRow& row : table.rows) EXPECT_EQ(row.cells.size(), table.columns.size());
  EXPECT_DOUBLE_EQ(std::get<double>(table.rows[0].cells[0]), 90.0);
  EXPECT_EQ(std::get<std::string>(table.rows[0].cells[1]), "locked");
  EXPECT_DOUBLE_EQ(std::get<double>(table.rows[0].cells[2]), 2.5);
  EXPECT_DOUBLE_EQ(std::get<double>(table.rows[0].cells[3]), 2.0);
  EXPECT_TRUE(std::holds_alternative<std::monostate>(table.rows[1].cells[2]));
}

TEST(operability_table, says_what_a_cell_without_a_limit_is) {
  const OperabilityResults results = chart();
  EXPECT_EQ(limit_state_label(results.cells[0]), "limit");
  EXPECT_EQ(limit_state_label(results.cells[1]), "below the least");
  EXPECT_EQ(limit_state_label(results.cells[2]), "above the largest");
  EXPECT_EQ(limit_state_label(results.cells[3]), "not decided");
}

TEST(operability_table, workability_stands_by_month) {
  OperabilityResults results = chart();
  EXPECT_TRUE(workability_table(results).rows.empty());
  results.workability = Workability{std::vector<double>(12, 0.5), 0.5, 0.1};
  results.forecast_workability = Workability{std::vector<double>(12, 0.25), 0.25, 0.1};
  const Table table = workability_table(results);
  ASSERT_EQ(table.rows.size(), 14U);
  EXPECT_EQ(std::get<std::string>(table.rows[1].cells[0]), "February");
  EXPECT_DOUBLE_EQ(std::get<double>(table.rows[1].cells[1]), 50.0);
  EXPECT_DOUBLE_EQ(std::get<double>(table.rows[12].cells[2]), 25.0);
  results.workability = Workability{{0.7}, 0.7, 0.0};
  results.forecast_workability.reset();
  EXPECT_EQ(workability_table(results).rows.size(), 2U);
}

TEST(operability_json, gives_back_all_that_was_put_in) {
  OperabilityResults results = chart();
  results.min_value = 0.5;
  results.max_value = 4.0;
  results.resolution = 0.25;
  results.seeds = {1, 5};
  results.runs = 28;
  results.wall_time = 12.5;
  results.remarks = {"1 of 4 cells are not decided"};
  results.workability = Workability{std::vector<double>(12, 0.5), 0.5, 0.1};
  results.forecast_workability = Workability{std::vector<double>(12, 0.25), 0.25, 0.2};
  const Json json = operability_json(results);
  const OperabilityResults read = operability_from_json(read_json(json_text(json)));
  EXPECT_EQ(operability_json(read), json);
  ASSERT_EQ(read.cells.size(), 4U);
  EXPECT_EQ(read.cells[0].limit, 2.5);
  EXPECT_FALSE(read.cells[1].limit);
  EXPECT_TRUE(read.cells[2].beyond);
  EXPECT_EQ(read.cells[3].reason, "interrupted");
  EXPECT_EQ(read.axes[1].value_texts, results.axes[1].value_texts);
  EXPECT_EQ(read.forecast_workability->outside, 0.2);
  EXPECT_EQ(csv_text(operability_table(read)), csv_text(operability_table(results)));
  EXPECT_THROW(operability_from_json(Json::object()), Json::exception);
}

}  // namespace overbend
