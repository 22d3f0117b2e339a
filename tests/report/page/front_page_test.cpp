#include "report/page/front_page.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <regex>

#include "report/bgl1_results.h"
#include "report/page_text.h"
#include "report/report.h"
#include "results/verdict.h"

namespace overbend {
namespace {

using testing::bgl1;
using testing::count;
using testing::visible;

CheckRow check_of(const char* name, CheckRegion region, CheckStatus status, double utilisation) {
  CheckRow row;
  row.name = name;
  row.code = "DNV-ST-F101 (2021)";
  row.region = region;
  row.status = status;
  row.utilisation = utilisation;
  return row;
}

CheckTable table_of(const std::vector<CheckRow>& rows) {
  CheckTable table;
  table.rows = rows;
  return table;
}

std::string words_of(const std::vector<CheckRow>& rows, const Findings& findings = {}) {
  return make_verdict(table_of(rows), findings).words;
}

TEST(verdict, is_passed_where_nothing_governing_is_exceeded) {
  CheckRow information = check_of("Propagation of a buckle", CheckRegion::line, CheckStatus::exceeded, 1.8);
  information.governing = false;
  const CheckRow passed = check_of("Equivalent stress, 0.87 f_y", CheckRegion::sagbend, CheckStatus::passed, 0.4);
  EXPECT_EQ(words_of({information, passed}), "PASSED");
}

TEST(verdict, names_the_exceeded_check_that_is_used_most_and_how_much) {
  const CheckRow tip = check_of("Clearance at the stinger tip", CheckRegion::line, CheckStatus::exceeded, 1.4321);
  const CheckRow strain =
      check_of("Laying criterion I, static strain", CheckRegion::overbend, CheckStatus::exceeded, 1.1);
  EXPECT_EQ(words_of({strain, tip}), "EXCEEDED 1.43, clearance at the stinger tip");
  EXPECT_EQ(words_of({strain}), "EXCEEDED 1.10, laying criterion I, static strain, overbend");
  EXPECT_NE(make_verdict(table_of({strain, tip}), {}).because.find("2 governing checks are exceeded."),
            std::string::npos);
}

TEST(verdict, an_exceeded_check_is_never_rounded_to_one) {
  EXPECT_EQ(words_of({check_of("Roller force", CheckRegion::line, CheckStatus::exceeded, 1.0004)}),
            "EXCEEDED 1.0004, roller force");
}

TEST(verdict, what_was_not_judged_and_serious_findings_are_reservations) {
  const CheckRow passed = check_of("Equivalent stress", CheckRegion::sagbend, CheckStatus::passed, 0.4);
  const CheckRow outside = check_of("Local buckling", CheckRegion::overbend, CheckStatus::outside_validity, 0.0);
  EXPECT_EQ(words_of({passed, outside}, unjudged_checks(table_of({outside}))),
            "PASSED WITH RESERVATIONS: 1 serious finding: check-not-judged");
  Findings findings = {{FindingCode::compression, "compression"}, {FindingCode::pipe_off_rollers, "off"}};
  EXPECT_EQ(words_of({passed}, findings),
            "PASSED WITH RESERVATIONS: 2 serious findings: compression, pipe-off-rollers");
  EXPECT_EQ(words_of({passed}, {{FindingCode::free_spans, "spans"}}), "PASSED");
  accept(findings, {"compression", "pipe-off-rollers"});
  EXPECT_EQ(words_of({passed}, findings), "PASSED");
}

TEST(verdict, without_any_judged_check_nothing_is_claimed) {
  EXPECT_EQ(words_of({}), "NOT JUDGED");
  EXPECT_EQ(words_of({check_of("Laying criterion II", CheckRegion::overbend, CheckStatus::not_done, 0.0)}),
            "NOT JUDGED");
}

TEST(front_page, a_line_that_is_used_most_does_not_hide_the_equipment) {
  CheckTable checks;
  CheckRow anchor = check_of("Anchor, holding power over safety factor", CheckRegion::line, CheckStatus::passed, 0.9);
  anchor.id = "anchor_load";
  checks.rows = {anchor, check_of("Roller force", CheckRegion::line, CheckStatus::passed, 0.4)};
  const std::string html = front_page(FrontPage{}, bgl1().results, checks, "");
  EXPECT_NE(html.find("<div class=\"region\">Anchors</div>"), std::string::npos);
  EXPECT_NE(html.find("<div class=\"region\">Line and equipment</div>"), std::string::npos);
}

/// Whether the sentences begin with these words, one by one.
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
  const std::string page = report_html(bgl1().results, bgl1().model_text);
  std::size_t place = 0;
  for (const char* part :
       {"<h3>Governing assumptions</h3>", "in statics they are frictionless", "<h3>Settings of the model file</h3>",
        "Water depth 89.00 m", "<h3>Other assumptions</h3>", "Field-joint infill"}) {
    const std::size_t found = page.find(part, place);
    ASSERT_NE(found, std::string::npos) << part;
    place = found;
  }
}

TEST(front_page, shows_the_document_control_of_the_model_file_and_leaves_room_for_the_rest) {
  const std::string text =
      bgl1().model_text + "\nreport: {client: Sea & Co, project: P1, document: D-7, revision: 2, prepared: AB}\n";
  const std::string page = visible(report_html(bgl1().results, text));
  EXPECT_NE(page.find("<dt>Client</dt><dd>Sea &amp; Co</dd>"), std::string::npos);
  EXPECT_NE(page.find("<dt>Revision</dt><dd>2</dd>"), std::string::npos);
  EXPECT_NE(page.find("<dt>Checked</dt><dd>&nbsp;</dd>"), std::string::npos);
  EXPECT_EQ(visible(report_html(bgl1().results, bgl1().model_text)).find("<dt>Client"), std::string::npos);
}

TEST(front_page, contents_link_to_every_section_that_follows_in_order) {
  const std::string page = visible(report_html(bgl1().results, bgl1().model_text));
  const std::string list = page.substr(page.find("<nav id=\"contents\">"), page.find("</nav>") - page.find("<nav id="));
  const std::string rest = page.substr(page.find("<div class=\"sections\">"));
  EXPECT_EQ(count(list, "<li>"), count(rest, "<section id="));
  const std::regex link("href=\"#([^\"]+)\"");
  std::size_t before = 0;
  for (auto at = std::sregex_iterator(list.begin(), list.end(), link); at != std::sregex_iterator(); ++at) {
    const std::size_t found = rest.find("<section id=\"" + (*at)[1].str() + "\"");
    ASSERT_NE(found, std::string::npos) << (*at)[1];
    EXPECT_GE(found, before) << (*at)[1];
    before = found;
  }
}

TEST(front_page, has_a_bar_for_every_region_with_a_judged_check) {
  const std::string page = visible(report_html(bgl1().results, bgl1().model_text));
  const std::string front = page.substr(0, page.find("<nav id=\"contents\">"));
  EXPECT_NE(front.find("<div class=\"words\">PASSED</div>"), std::string::npos);
  EXPECT_EQ(count(front, "<div class=\"bar"), 5u);
  for (const char* region : {"Overbend", "Stinger tip", "Sagbend", "Seabed", "Line and equipment"}) {
    EXPECT_NE(front.find("<div class=\"region\">" + std::string(region) + "</div>"), std::string::npos) << region;
  }
}

TEST(front_page, what_only_a_checker_reads_stands_in_the_appendix) {
  const std::string page = visible(report_html(bgl1().results, bgl1().model_text));
  const std::size_t assumptions = page.find("<section id=\"assumptions\">");
  for (const char* id : {"rollers", "check-inputs", "balance", "model"}) {
    const std::size_t at = page.find("<section id=\"" + std::string(id) + "\">");
    ASSERT_NE(at, std::string::npos) << id;
    EXPECT_GT(at, assumptions) << id;
    EXPECT_EQ(page.find("<h2>Appendix: ", at), page.find("<h2>", at)) << id;
  }
}

TEST(lay_setting, tells_of_every_box_how_it_is_set_and_what_that_makes_it_carry) {
  const std::string page = visible(report_html(bgl1().results, bgl1().model_text));
  const std::size_t at = page.find("<section id=\"lay-setting\">");
  ASSERT_NE(at, std::string::npos);
  EXPECT_LT(at, page.find("<section id=\"checks\">"));
  const std::string section = page.substr(at, page.find("</section>", at) - at);
  EXPECT_EQ(count(section, "<tr"), bgl1().results.supports.size() + 1);
  const std::string last = section.substr(section.rfind("<tr"));
  EXPECT_NE(last.find("<td>412</td>"), std::string::npos) << last;
}

}  // namespace
}  // namespace overbend
