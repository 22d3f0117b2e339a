// Stages of an operation on the line in summary.json, stages.csv and results.h5.
#include "resultfiles/stages/operation_writer.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "base/json.h"
#include "resultfiles/stages/operation_reader.h"
#include "resultfiles/stages/stage_table.h"
#include "resultfiles/tables/data_table.h"
#include "support/lay_bits.h"
#include "support/solved_case.h"

namespace overbend {
namespace {

using testing::result_bits;
using testing::solved_case;
using testing::TemporaryFolder;

/// A stage that stands, one that does not, one with a tension that was sought.
OperationResults three_stages() {
  OperationResults results;
  results.title = "lay-down";
  results.version = "1";
  results.type = OperationType::abandonment;
  results.findings = {{FindingCode::unknown, "one warning"}};
  results.assumptions = {{AssumptionRank::governing, "one assumption"}};
  results.wall_time = 0.25;
  StageResult& first = results.stages.emplace_back();
  first.stage = {"over the stinger", 60.0, {}, {}, {}, 420e3, {}, {}, {}};
  first.lay = solved_case("BGL1-T250").results;
  first.lay->head = HeadResult{Vec3(-99.5, 0.0, -15.75), 39.5, 0.44, 0.53, 295e3, 73.0, 500.0};
  first.lay->cable = CableResult{60.0, 300e3, 0.07, 0.1};
  StageResult& second = results.stages.emplace_back();
  second.stage = {"too slack", 150.0, {}, {}, {}, 20e3, {}, {}, {}};
  second.failure = StageFailure{"no equilibrium", "sagbend", "the tension is below the weight", 61e3};
  StageResult& third = results.stages.emplace_back();
  third.stage = {"bed", 200.0, {}, {}, {}, 180e3, {}, {}, {}};
  third.lay = solved_case("J12-D400-T560").results;
  third.lay->far_anchor = StartUpAnchorResult{900.0, 205e3, 290.0};
  third.barge_ahead = 12.5;
  third.governing = "sagbend strain";
  third.findings = {{FindingCode::unknown, "tension below the range"}};
  return results;
}

const Json& summary() {
  static const Json kSummary = read_json(operation_summary(three_stages()));
  return kSummary;
}

TEST(operation_writer, every_stage_has_the_keys_of_statics) {
  const Json stages = summary()["operation"]["stages"];
  ASSERT_EQ(stages.size(), 3U);
  EXPECT_EQ(summary()["operation"]["type"], "abandonment");
  EXPECT_EQ(summary()["status"], "some stages failed");
  EXPECT_EQ(stages[0]["name"], "over the stinger");
  EXPECT_EQ(stages[0]["status"], "converged");
  EXPECT_EQ(stages[0]["cable_out"], 60.0);
  EXPECT_EQ(stages[0]["tension"], 420e3);
  EXPECT_FALSE(stages[0].contains("pipe_out"));
  const StaticResults& lay = solved_case("BGL1-T250").results;
  EXPECT_EQ(stages[0]["bottom_tension"], lay.bottom_tension);
  EXPECT_EQ(stages[0]["top_inclination"], lay.top_inclination);
  EXPECT_EQ(stages[0]["sagbend"]["max_bending_moment"], lay.sagbend.bending_moment.value);
  EXPECT_EQ(stages[0]["supports"].size(), lay.supports.size());
  EXPECT_FALSE(stages[0]["checks"]["worst"].is_null());
  EXPECT_EQ(stages[2]["barge_ahead"], 12.5);
  EXPECT_EQ(stages[2]["governing"], "sagbend strain");
  EXPECT_EQ(stages[2]["warnings"][0], "tension below the range");
}

TEST(operation_writer, the_pipe_has_its_derived_properties_at_the_top_as_in_statics) {
  const DerivedSection& pipe = solved_case("BGL1-T250").results.sections.front();
  const Json derived = summary()["derived"];
  EXPECT_EQ(derived["EI"], pipe.EI);
  EXPECT_EQ(derived["weight_submerged"], pipe.weight_submerged);
  OperationResults fallen = three_stages();
  for (StageResult& stage : fallen.stages) stage.lay.reset();
  EXPECT_EQ(read_json(operation_summary(fallen))["derived"], Json::object());
}

TEST(operation_writer, the_head_is_reported_astern_of_the_shoe_and_above_the_water) {
  const Json head = summary()["operation"]["stages"][0]["head"];
  EXPECT_EQ(head["x"], 39.5);
  EXPECT_EQ(head["z"], -15.75);
  EXPECT_EQ(head["tension"], 295e3);
  EXPECT_EQ(head["clearance"], 73.0);
  EXPECT_EQ(head["inclination"], 0.44);
  EXPECT_EQ(head["cable_inclination"], 0.53);
  EXPECT_EQ(summary()["operation"]["stages"][0]["cable"]["utilisation"], 0.07);
  EXPECT_FALSE(summary()["operation"]["stages"][2].contains("head"));
}

TEST(operation_writer, the_anchor_of_a_start_up_has_its_distance_next_to_its_place) {
  const Json anchor = summary()["operation"]["stages"][2]["anchor"];
  EXPECT_EQ(anchor["distance"], 900.0);
  EXPECT_EQ(anchor["uplift"], 290.0);
  EXPECT_EQ(anchor["horizontal"], 205e3);
  EXPECT_EQ(anchor["x"], solved_case("J12-D400-T560").results.anchor_W.x());
}

TEST(operation_writer, a_stage_that_cannot_be_says_why_and_has_no_results) {
  const Json stage = summary()["operation"]["stages"][1];
  EXPECT_EQ(stage["status"], "failed");
  EXPECT_EQ(stage["failure"]["what"], "no equilibrium");
  EXPECT_EQ(stage["failure"]["where"], "sagbend");
  EXPECT_EQ(stage["failure"]["least_tension"], 61e3);
  EXPECT_FALSE(stage.contains("sagbend"));
}

TEST(operation_writer, the_check_used_most_names_its_stage) {
  const Json worst = summary()["checks"]["worst"];
  double max_value = 0.0;
  std::string text_place;
  for (const Json& stage : summary()["operation"]["stages"]) {
    if (stage["status"] != "converged" || stage["checks"]["worst"]["utilisation"] <= max_value) continue;
    max_value = stage["checks"]["worst"]["utilisation"];
    text_place = stage["name"];
  }
  EXPECT_EQ(worst["utilisation"], max_value);
  EXPECT_EQ(worst["stage"], text_place);
}

TEST(operation_writer, all_or_no_stages_have_a_word) {
  OperationResults results = three_stages();
  results.stages.erase(results.stages.begin() + 1);
  EXPECT_EQ(read_json(operation_summary(results))["status"], "converged");
  results = three_stages();
  for (StageResult& stage : results.stages) stage.lay.reset();
  EXPECT_EQ(read_json(operation_summary(results))["status"], "failed");
  EXPECT_TRUE(read_json(operation_summary(results))["checks"]["worst"].is_null());
}

TEST(operation_writer, results_come_back_bit_for_bit) {
  const OperationResults results = three_stages();
  const TemporaryFolder folder;
  write_operation_files(results, solved_case("BGL1-T250").description, folder.path());
  ASSERT_TRUE(has_lay_operation(folder / "results.h5"));
  const StoredOperation stored = read_operation_results(folder / "results.h5");
  EXPECT_EQ(stored.model_text, testing::file_text(testing::case_file("BGL1-T250")));
  EXPECT_EQ(operation_summary(stored.results), operation_summary(results));
  EXPECT_EQ(csv_text(stages_table(stored.results)), csv_text(stages_table(results)));
  ASSERT_EQ(stored.results.stages.size(), 3U);
  for (const std::size_t i : {std::size_t{0}, std::size_t{2}}) {
    EXPECT_EQ(result_bits(*stored.results.stages[i].lay), result_bits(*results.stages[i].lay)) << i;
  }
  EXPECT_FALSE(stored.results.stages[1].lay);
  EXPECT_EQ(stored.results.stages[1].failure->min_tension, 61e3);
}

std::vector<std::string> csv_lines(const std::string& text) {
  std::vector<std::string> lines;
  for (std::size_t start = 0; start < text.size();) {
    const std::size_t end = text.find("\r\n", start);
    lines.push_back(text.substr(start, end - start));
    start = end + 2;
  }
  return lines;
}

TEST(stage_table, has_a_row_per_stage_in_engineering_units) {
  const std::vector<std::string> lines = csv_lines(csv_text(stages_table(three_stages())));
  ASSERT_EQ(lines.size(), 4U);
  EXPECT_EQ(lines[0].rfind("stage,cable out [m],tension [kN],status,", 0), 0U) << lines[0];
  EXPECT_EQ(lines[1].rfind("over the stinger,60,420,converged,", 0), 0U) << lines[1];
  EXPECT_EQ(lines[2].rfind("too slack,150,20,no equilibrium,", 0), 0U) << lines[2];
  for (const char* head : {"head height [m]", "cable utilisation", "anchor distance [m]", "least tension [kN]",
                           "sagbend strain [%]", "decisive check"}) {
    EXPECT_NE(lines[0].find(head), std::string::npos) << head;
  }
  EXPECT_EQ(lines[0].find("pipe out"), std::string::npos);  // nothing is said of it at any stage
}

TEST(stage_table, has_no_stress_of_a_sagbend_that_is_cable_alone) {
  OperationResults results = three_stages();
  results.stages[0].lay->sagbend = {};
  int found = 0;
  for (const StageTableColumn& column : stage_table_columns(results)) {
    if (!column.heading.starts_with("sagbend")) continue;
    ++found;
    EXPECT_TRUE(std::isnan(column.numbers[0])) << column.heading;
    EXPECT_GT(column.numbers[2], 0.0) << column.heading;
  }
  EXPECT_EQ(found, 3);
}

TEST(stage_table, has_as_many_cells_in_every_row) {
  for (const StageTableColumn& column : stage_table_columns(three_stages())) {
    EXPECT_EQ(column.text ? column.texts.size() : column.numbers.size(), 3U) << column.heading;
  }
}

TEST(operation_writer, no_number_that_is_none_is_written) {
  OperationResults results = three_stages();
  results.stages[0].lay->head->tension = std::numeric_limits<double>::quiet_NaN();
  const TemporaryFolder folder;
  EXPECT_THROW(write_operation_files(results, {}, folder.path()), std::runtime_error);
  EXPECT_FALSE(std::filesystem::exists(folder / "summary.json"));
}

}  // namespace
}  // namespace overbend
