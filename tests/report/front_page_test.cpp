#include "report/front_page.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>

#include "report/assumption_rank.h"
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

/// All text between quotes of the sources that speak of assumptions and warnings, pieces of one text joined.
std::string said_by_the_program() {
  std::string text;
  for (const char* folder : {"model", "checks", "hull", "system", "statics", "dynamics", "recording", "report",
                             "results", "study", "seafiles", "modelfile"}) {
    for (const auto& entry :
         std::filesystem::recursive_directory_iterator(std::string(OVERBEND_SOURCE_DIR) + "/src/overbend/" + folder)) {
      const std::string name = entry.path().filename();
      if (entry.path().extension() != ".cpp" || name == "assumption_rank.cpp") continue;
      std::ifstream in(entry.path());
      text += std::string(std::istreambuf_iterator<char>(in), {});
    }
  }
  return std::regex_replace(text, std::regex("\"\\s*\n\\s*\""), "");
}

TEST(report_phrases, are_all_said_by_the_program) {
  const std::string said = said_by_the_program();
  std::vector<std::string> phrases;
  for (const AssumptionRank rank : {AssumptionRank::decides, AssumptionRank::given}) {
    const std::vector<std::string>& more = assumption_phrases(rank);
    phrases.insert(phrases.end(), more.begin(), more.end());
  }
  for (const std::string& phrase : phrases) EXPECT_NE(said.find(phrase), std::string::npos) << phrase;
}

TEST(assumptions, what_decides_stands_before_what_was_given_and_the_rest) {
  const auto lists = ranked(bgl1().results.assumptions);
  EXPECT_GE(lists[0].size(), 5u);
  EXPECT_GE(lists[1].size(), 5u);
  EXPECT_EQ(lists[0].size() + lists[1].size() + lists[2].size(), bgl1().results.assumptions.size());
  const std::string page = report_html(bgl1().results, bgl1().model_text);
  const std::size_t decides = page.find("<h3>Governing assumptions</h3>");
  EXPECT_LT(decides, page.find("Steel of section"));
  EXPECT_LT(page.find("in statics they are frictionless"), page.find("<h3>Settings of the model file"));
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
