#include "report/stages/operation_report.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "report/bgl1_results.h"
#include "report/page_text.h"
#include "report/stages/operation_verdict.h"
#include "report/stages/procedure_section.h"
#include "report/stages/stages_data.h"
#include "report/synthetic_operation.h"
#include "results/findings.h"

namespace overbend {
namespace {

using testing::abandonment_text;
using testing::count;
using testing::row_count;
using testing::section_text;
using testing::shown_text;
using testing::synthetic_abandonment;
using testing::synthetic_start_up;

bool has(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

/// Head, cable and a program as the model would give them.
Description described() {
  Description d;
  d.operation.type = OperationType::abandonment;
  d.operation.lay.head = HeadDescription{6.0, 40e3, 33e3, {}};
  d.operation.lay.cable = CableDescription{};
  d.operation.lay.cable->breaking_load = 900e3;
  d.operation.lay.program = StageProgram{};
  d.operation.lay.program->limits.tip_clearance = 0.3;
  d.operation.lay.program->limits.utilisation = 0.5;
  return d;
}

TEST(operation_report, begins_with_what_cannot_be_and_why) {
  const Document document = operation_report_document(synthetic_abandonment(), abandonment_text());
  const std::string front = testing::front_text(document.front), failed = section_text(document, "stages");
  EXPECT_TRUE(has(front, "1 OF 6 STAGES WITHOUT EQUILIBRIUM"));
  EXPECT_TRUE(has(front, "Stage 6"));
  EXPECT_TRUE(has(failed, "the tension is below the suspended weight"));
  EXPECT_TRUE(has(failed, "61.5 kN or more"));
}

TEST(operation_report, has_a_row_for_every_stage_with_its_numbers) {
  const OperationResults results = synthetic_abandonment();
  const Document document = operation_report_document(results, abandonment_text());
  const std::string stages = section_text(document, "stages");
  const std::size_t standing = results.stages.size() - 1;
  EXPECT_EQ(row_count(testing::section_body(document, "stages")), results.stages.size() + standing);
  EXPECT_EQ(count(stages, "\nover: "), 1u);
  for (const StageResult& stage : results.stages) {
    if (!stage.lay) continue;
    EXPECT_TRUE(has(stages, " | " + fixed(stage.lay->top_tension / 1e3, 1) + " | "));
    EXPECT_TRUE(has(stages, " | " + fixed(stage.lay->sagbend.strain.value * 100.0, 4) + " | "));
    EXPECT_TRUE(has(stages, " | " + fixed(stage.lay->head->p_W.z(), 2) + " | "));
  }
}

CheckRow cable_row(double utilisation) {
  CheckRow row;
  row.id = "cable_load";
  row.name = "Cable, breaking load over safety factor";
  row.utilisation = utilisation;
  row.status = utilisation > 1.0 ? CheckStatus::exceeded : CheckStatus::passed;
  return row;
}

TEST(operation_report, verdict_is_that_of_the_hardest_stage) {
  OperationResults results = synthetic_abandonment();
  results.stages.pop_back();
  results.stages[2].lay->checks.rows.push_back(cable_row(1.2));
  const Verdict verdict = verdict_with_stage(results);
  EXPECT_EQ(verdict.kind, VerdictKind::exceeded);
  EXPECT_EQ(verdict.headline, "EXCEEDED 1.20, cable, breaking load over safety factor, stage 3");
  EXPECT_EQ(verdict_with_stage(results).kind, operation_verdict(results).kind);
  for (StageResult& stage : results.stages) stage.lay->checks.rows.clear();
  EXPECT_EQ(verdict_with_stage(results).kind, VerdictKind::not_judged);
}

TEST(operation_report, bars_are_the_largest_over_the_stages) {
  OperationResults results = synthetic_abandonment();
  results.stages[0].lay->checks.rows.push_back(cable_row(0.6));
  results.stages[1].lay->checks.rows.push_back(cable_row(0.7));
  const std::vector<Utilisation> bars = operation_bars(results);
  ASSERT_FALSE(bars.empty());
  EXPECT_EQ(bars.back().title, "Line and equipment");
  EXPECT_EQ(bars.back().utilisation, 0.7);
  EXPECT_NE(bars.back().what.find("stage 2"), std::string::npos);
}

TEST(operation_report, says_a_finding_of_several_stages_once) {
  OperationResults results = synthetic_abandonment();
  for (StageResult& stage : results.stages) {
    if (stage.lay) stage.lay->findings = {{FindingCode::rollers_below_seabed, "rollers are below the seabed"}};
  }
  results.stages[1].lay->findings.push_back({FindingCode::free_spans, "only here"});
  const Findings findings = operation_findings(results);
  const auto with = [&](const std::string& text) {
    return std::count_if(findings.begin(), findings.end(),
                         [&](const Finding& finding) { return finding.message.find(text) != std::string::npos; });
  };
  EXPECT_EQ(with("ollers are below the seabed (stages 1, 2, 3, 4, 5)"), 1);
  EXPECT_EQ(with("ollers are below the seabed"), 1);
  EXPECT_EQ(with("nly here (stage 2)"), 1);
  EXPECT_EQ(findings.front().code, FindingCode::stage_without_equilibrium);
}

TEST(operation_report, procedure_sheet_says_what_to_hold_and_when_to_stop) {
  const OperationResults results = synthetic_abandonment();
  const Blocks section = procedure_section(results, described());
  const std::string sheet = shown_text(section);
  EXPECT_EQ(row_count(section.json()), results.stages.size());
  EXPECT_TRUE(has(sheet, "HOLD before: "));
  EXPECT_TRUE(has(sheet, "the head leaves the stinger tip (at cable out "));
  EXPECT_TRUE(has(sheet, "INFEASIBLE as planned"));
  EXPECT_TRUE(has(sheet, "Tension of the cable above 150.0 kN: "));  // 0.5 of 900 kN over 3
  EXPECT_TRUE(has(sheet, "Clearance at the stinger tip below 0.30 m."));
  EXPECT_TRUE(has(sheet, "Accepted on board | \n"));
  // The tension found for the limits is the least of the stage that was sought.
  const std::string min_value = fixed(*results.stages[3].stage.tension / 1e3, 1);
  EXPECT_TRUE(has(sheet, " | " + min_value + " | " + min_value + " | "));
}

TEST(operation_report, contains_its_sheet_before_the_stages) {
  const Document document = operation_report_document(synthetic_abandonment(), abandonment_text());
  const std::vector<std::string> ids = testing::section_ids(document);
  ASSERT_GE(ids.size(), 2u);
  EXPECT_EQ(ids[0], "procedure");
  EXPECT_EQ(ids[1], "stages");
}

TEST(operation_report, survives_results_without_any_stage_and_hostile_text) {
  EXPECT_TRUE(has(testing::front_text(operation_report_document({}, "").front), "NOT JUDGED"));
  OperationResults results = synthetic_abandonment();
  results.stages[0].stage.name = "<script>alert(1)</script>";
  results.stages[5].failure->why = "</script><b>";
  const std::string page = page_text(operation_report_document(results, ""));
  EXPECT_FALSE(has(page, "<script>alert"));
  EXPECT_FALSE(has(page, "</script><b>"));
}

TEST(operation_report, stays_below_a_size_that_mail_carries_with_fifty_stages) {
  OperationResults results = synthetic_abandonment();
  while (results.stages.size() < 50) results.stages.push_back(results.stages[results.stages.size() % 5]);
  EXPECT_LT(page_text(operation_report_document(results, abandonment_text())).size(), 2'500'000u);
}

TEST(stages_data, parts_the_line_at_the_head) {
  for (const bool start_up : {false, true}) {
    const OperationResults results = start_up ? synthetic_start_up() : synthetic_abandonment();
    const Json data = stages_data(results, described())["stages"];
    ASSERT_EQ(data["list"].size(), results.stages.size());
    EXPECT_TRUE(data["list"].back()["line"].is_null());
    const auto& runs = data["list"][2]["line"];
    ASSERT_EQ(runs.size(), 3u);
    EXPECT_EQ(runs[0]["of"], start_up ? "pipe" : "cable");  // from the top on
    EXPECT_EQ(runs[1]["of"], "head");
    EXPECT_EQ(runs[2]["of"], start_up ? "cable" : "pipe");
    // Each run ends where the next begins, and the head is as long as described.
    for (int i = 0; i < 2; ++i) EXPECT_EQ(runs[i]["points"].back(), runs[i + 1]["points"].front());
    const auto &from = runs[1]["points"].front(), &to = runs[1]["points"].back();
    const double long_ =
        std::hypot(to[0].get<double>() - from[0].get<double>(), to[1].get<double>() - from[1].get<double>());
    EXPECT_NEAR(long_, 6.0, 2.0);  // to the next station at either end
  }
}

TEST(stages_data, curves_are_gaps_where_a_stage_cannot_be) {
  const OperationResults results = synthetic_abandonment();
  const Json data = stages_data(results, described())["stages"];
  ASSERT_GE(data["curves"].size(), 8u);
  for (const auto& curve : data["curves"]) {
    ASSERT_EQ(curve["values"].size(), results.stages.size());
    EXPECT_TRUE(curve["values"].back().is_null()) << curve["key"];
    if (curve["key"] == "depth") {
      EXPECT_NEAR(curve["values"][4], -results.stages[4].lay->head->p_W.z(), 1e-3);
    }
    if (curve["key"] == "tip") {
      EXPECT_EQ(curve["limit"], 0.3);
    }
    if (curve["key"] == "cable") {
      EXPECT_EQ(curve["limit"], 50.0);
    }
  }
}

}  // namespace
}  // namespace overbend
