#include "report/page/front_page.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "report/bgl1_results.h"
#include "report/page_text.h"
#include "report/report.h"
#include "results/verdict.h"

namespace overbend {
namespace {

using testing::bgl1;
using testing::section_text;

CheckRow make_check_row(const char* name, CheckRegion region, CheckStatus status, double utilisation) {
  CheckRow row;
  row.name = name;
  row.code = "DNV-ST-F101 (2021)";
  row.region = region;
  row.status = status;
  row.utilisation = utilisation;
  return row;
}

CheckTable make_row_table(const std::vector<CheckRow>& rows) {
  CheckTable table;
  table.rows = rows;
  return table;
}

std::string enum_names(const std::vector<CheckRow>& rows, const Findings& findings = {}) {
  return make_verdict(make_row_table(rows), findings).headline;
}

std::vector<std::string> bar_titles(const Json& front) {
  std::vector<std::string> titles;
  for (const Json& bar : front["utilisation"]["bars"]) titles.push_back(bar["title"]);
  return titles;
}

TEST(verdict, is_passed_where_nothing_governing_is_exceeded) {
  CheckRow information = make_check_row("Propagation of a buckle", CheckRegion::line, CheckStatus::exceeded, 1.8);
  information.governing = false;
  const CheckRow passed = make_check_row("Equivalent stress, 0.87 f_y", CheckRegion::sagbend, CheckStatus::passed, 0.4);
  EXPECT_EQ(enum_names({information, passed}), "PASSED");
}

TEST(verdict, names_the_exceeded_check_that_is_used_most_and_how_much) {
  const CheckRow tip = make_check_row("Clearance at the stinger tip", CheckRegion::line, CheckStatus::exceeded, 1.4321);
  const CheckRow strain =
      make_check_row("Laying criterion I, static strain", CheckRegion::overbend, CheckStatus::exceeded, 1.1);
  EXPECT_EQ(enum_names({strain, tip}), "EXCEEDED 1.43, clearance at the stinger tip");
  EXPECT_EQ(enum_names({strain}), "EXCEEDED 1.10, laying criterion I, static strain, overbend");
  EXPECT_NE(make_verdict(make_row_table({strain, tip}), {}).because.find("2 governing checks are exceeded."),
            std::string::npos);
}

TEST(verdict, an_exceeded_check_is_never_rounded_to_one) {
  EXPECT_EQ(enum_names({make_check_row("Roller force", CheckRegion::line, CheckStatus::exceeded, 1.0004)}),
            "EXCEEDED 1.0004, roller force");
}

TEST(verdict, what_was_not_judged_and_serious_findings_are_reservations) {
  const CheckRow passed = make_check_row("Equivalent stress", CheckRegion::sagbend, CheckStatus::passed, 0.4);
  const CheckRow outside = make_check_row("Local buckling", CheckRegion::overbend, CheckStatus::outside_validity, 0.0);
  EXPECT_EQ(enum_names({passed, outside}, find_invalid_checks(make_row_table({outside}))),
            "PASSED WITH RESERVATIONS: 1 serious finding: check-not-judged");
  Findings findings = {{FindingCode::compression, "compression"}, {FindingCode::pipe_off_rollers, "off"}};
  EXPECT_EQ(enum_names({passed}, findings),
            "PASSED WITH RESERVATIONS: 2 serious findings: compression, pipe-off-rollers");
  EXPECT_EQ(enum_names({passed}, {{FindingCode::free_spans, "spans"}}), "PASSED");
  accept(findings, {"compression", "pipe-off-rollers"});
  EXPECT_EQ(enum_names({passed}, findings), "PASSED");
}

TEST(verdict, without_any_judged_check_nothing_is_claimed) {
  EXPECT_EQ(enum_names({}), "NOT JUDGED");
  EXPECT_EQ(enum_names({make_check_row("Laying criterion II", CheckRegion::overbend, CheckStatus::not_done, 0.0)}),
            "NOT JUDGED");
}

TEST(front_page, a_line_that_is_used_most_does_not_hide_the_equipment) {
  CheckTable checks;
  CheckRow anchor =
      make_check_row("Anchor, holding power over safety factor", CheckRegion::line, CheckStatus::passed, 0.9);
  anchor.id = "anchor_load";
  checks.rows = {anchor, make_check_row("Roller force", CheckRegion::line, CheckStatus::passed, 0.4)};
  const std::vector<std::string> titles = bar_titles(front_page(FrontPage{}, bgl1().results, checks));
  EXPECT_EQ(titles, (std::vector<std::string>{"Line and equipment", "Anchors"}));
}

/// True if the sentences begin with these words, one by one.
void expect_beginnings(const std::vector<std::string>& sentences, const std::vector<std::string>& beginnings) {
  ASSERT_EQ(sentences.size(), beginnings.size());
  for (std::size_t i = 0; i < sentences.size(); ++i) {
    EXPECT_TRUE(sentences[i].starts_with(beginnings[i])) << sentences[i] << "\n" << beginnings[i];
  }
}

TEST(assumptions, of_the_example_have_their_ranks) {
  const std::vector<std::string> governing = {
      "EA and EI are those of the",       "Steel of section 'pipe':",       "The vessel moves by linear",
      "Rollers are rigid cylinders",      "Contact of 'pipe' with a",       "The laid pipe rests under",
      "Hard impacts amplify the",         "The steel stays linear in",      "Code checks: the formulas of D",
      "Code checks: the formulas of API", "Code checks: over the supports", "Code checks: a static state,",
      "Code checks: the manufacture",     "Code checks: the tensile"};
  const std::vector<std::string> settings = {
      "The pipe is empty, at atmospheric", "The weight density of water",    "The stern shoe, origin of",
      "The vessel floats on even",         "Water depth 89.00 m applies",    "The tension of 250 kN is",
      "The tensioner holds the pipe's",    "The seabed stiffness is 100",    "The current is steady; drag",
      "Waves and vessel motion are",       "The sea has a JONSWAP spectrum", "It is the sum of 200 linear",
      "Morison's coefficients do",         "The tensioner waits 2 s when",   "Impacts weaker than 1 kN",
      "Code checks: installation,",        "Code checks: API RP 1111,"};
  const Assumptions& all = bgl1().results.assumptions;
  expect_beginnings(texts(all, AssumptionRank::governing), governing);
  expect_beginnings(texts(all, AssumptionRank::setting), settings);
  EXPECT_EQ(texts(all, AssumptionRank::other).size(), 21u);
}

TEST(assumptions, stand_in_the_report_under_the_headings_of_their_ranks) {
  const std::string page = section_text(report_document(bgl1().results, bgl1().model_text), "assumptions");
  std::size_t place = 0;
  for (const char* part : {"Governing assumptions", "in statics they are frictionless", "Settings of the model file",
                           "Water depth 89.00 m", "Other assumptions", "Field-joint infill"}) {
    const std::size_t found = page.find(part, place);
    ASSERT_NE(found, std::string::npos) << part;
    place = found;
  }
}

TEST(front_page, shows_the_document_control_of_the_model_file_and_leaves_room_for_the_rest) {
  const std::string text =
      bgl1().model_text + "\nreport: {client: Sea & Co, project: P1, document: D-7, revision: 2, prepared: AB}\n";
  const Json control = report_document(bgl1().results, text).front["control"];
  EXPECT_EQ(control[0], Json({"Client", "Sea & Co"}));
  EXPECT_EQ(control[3], Json({"Revision", "2"}));
  EXPECT_EQ(control[5], Json({"Checked", ""}));
  EXPECT_FALSE(report_document(bgl1().results, bgl1().model_text).front.contains("control"));
}

TEST(front_page, has_a_bar_for_every_region_with_a_judged_check) {
  const Json front = report_document(bgl1().results, bgl1().model_text).front;
  EXPECT_EQ(front["verdict"]["words"], "PASSED");
  EXPECT_EQ(bar_titles(front),
            (std::vector<std::string>{"Overbend", "Stinger tip", "Sagbend", "Seabed", "Line and equipment"}));
}

TEST(front_page, what_only_a_checker_reads_stands_in_the_appendix) {
  const Document document = report_document(bgl1().results, bgl1().model_text);
  std::vector<std::string> appendices;
  bool behind = false;
  for (const Json& section : document.body.json()) {
    const std::string heading = section["heading"];
    if (behind) appendices.push_back(section["id"]);
    EXPECT_EQ(heading.starts_with("Appendix: "), behind) << heading;
    behind = behind || section["id"] == "assumptions";
  }
  EXPECT_EQ(appendices, (std::vector<std::string>{"rollers", "calculation-sheet", "check-inputs", "balance", "model"}));
}

TEST(lay_setting, reports_for_every_box_how_it_is_set_and_what_that_makes_it_carry) {
  const Document document = report_document(bgl1().results, bgl1().model_text);
  const std::vector<std::string> ids = testing::section_ids(document);
  EXPECT_LT(std::ranges::find(ids, "lay-setting"), std::ranges::find(ids, "checks"));
  const Json body = testing::section_body(document, "lay-setting");
  EXPECT_EQ(testing::row_count(body), bgl1().results.supports.size());
  Json table = body[0];
  table["rows"] = {table["rows"].back()};
  const std::string last = testing::table_as_text(table);
  EXPECT_NE(last.find("412"), std::string::npos) << last;
}

}  // namespace
}  // namespace overbend
