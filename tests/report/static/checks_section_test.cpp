#include "report/static/checks_section.h"

#include <gtest/gtest.h>

#include "report/bgl1_results.h"
#include "report/page_text.h"
#include "report/report.h"

namespace overbend {
namespace {

using testing::bgl1;
using testing::count;

std::string section_of(const CheckTable& table) {
  int figure = 0;
  return checks_section(bgl1().results, table, figure);
}

TEST(checks_section, tells_every_check_with_its_code) {
  const CheckTable& table = bgl1().results.checks;
  const std::string text = section_of(table);
  for (const CheckRow& row : table.rows) {
    EXPECT_NE(text.find(">" + row.name + "<"), std::string::npos) << row.name;
    EXPECT_NE(text.find(row.code), std::string::npos) << row.code;
  }
  for (const char* said : {"Governing check of each region", "No governing check is exceeded",
                           "see the calculation sheet", "not done: needs a dynamic analysis", "for information"}) {
    EXPECT_NE(text.find(said), std::string::npos) << said;
  }
  EXPECT_EQ(count(text, "data-figure=\"checks\""), 2u);
  EXPECT_EQ(count(text, "nan"), 0u);
}

TEST(checks_section, says_what_is_exceeded_and_marks_it) {
  CheckTable table = bgl1().results.checks;
  for (CheckRow& row : table.rows) {
    if (row.id != "dnv_equivalent_stress" || row.region != CheckRegion::sagbend) continue;
    row.utilisation = 1.25;
    row.status = CheckStatus::exceeded;
  }
  const std::string text = section_of(table);
  EXPECT_NE(text.find("1 governing check is exceeded"), std::string::npos);
  EXPECT_NE(text.find("1.250"), std::string::npos);
  EXPECT_EQ(count(text, "<tr class=\"over\">"), 2u);  // among the governing ones and in its region
}

TEST(checks_section, does_not_count_what_lies_outside_validity_as_passed) {
  CheckTable table = bgl1().results.checks;
  for (CheckRow& row : table.rows) {
    if (row.id == "dnv_load_controlled" && row.region == CheckRegion::sagbend)
      row.status = CheckStatus::outside_validity;
  }
  EXPECT_NE(section_of(table).find("1 outside the validity"), std::string::npos);
}

TEST(checks_section, is_absent_without_checks) {
  EXPECT_EQ(section_of(CheckTable{}), "");
  EXPECT_TRUE(checks_figure_data(bgl1().results, CheckTable{}).is_null());
}

TEST(checks_section, stands_before_the_figures_of_the_report) {
  const std::string page = testing::visible(report_html(bgl1().results, bgl1().model_text));
  ASSERT_NE(page.find("id=\"checks\""), std::string::npos);
  EXPECT_LT(page.find("id=\"checks\""), page.find("id=\"figures\""));
}

}  // namespace
}  // namespace overbend
