#include "report/static/checks_section.h"

#include <gtest/gtest.h>

#include "report/bgl1_results.h"
#include "report/page_text.h"
#include "report/report.h"

namespace overbend {
namespace {

using testing::bgl1;
using testing::count;

std::string section_text(const CheckTable& table) {
  return testing::shown_text(checks_section(bgl1().results, table));
}

TEST(checks_section, reports_every_check_with_its_code) {
  const CheckTable& table = bgl1().results.checks;
  const std::string text = section_text(table);
  for (const CheckRow& row : table.rows) {
    EXPECT_NE(text.find(row.name + " | " + row.code), std::string::npos) << row.name;
  }
  for (const char* said : {"Governing check of each region", "No governing check is exceeded",
                           "not done: needs a dynamic analysis", "for information"}) {
    EXPECT_NE(text.find(said), std::string::npos) << said;
  }
  EXPECT_EQ(count(text, "nan"), 0u);
  const Json section = checks_section(bgl1().results, table).json().front();
  EXPECT_EQ(section["body"][0]["link"],
            Json({{"text", "Basis of the checks: see the calculation sheet."}, {"to", "calculation-sheet"}}));
  EXPECT_EQ(section["body"][2]["parts"], Json({"whole", "overbend"}));
}

TEST(checks_section, says_what_is_exceeded_and_marks_it) {
  CheckTable table = bgl1().results.checks;
  for (CheckRow& row : table.rows) {
    if (row.id != "dnv_equivalent_stress" || row.region != CheckRegion::sagbend) continue;
    row.utilisation = 1.25;
    row.status = CheckStatus::exceeded;
  }
  const std::string text = section_text(table);
  EXPECT_NE(text.find("1 governing check is exceeded"), std::string::npos);
  EXPECT_NE(text.find("1.250"), std::string::npos);
  EXPECT_EQ(count(text, "\nover: "), 2u);  // among the governing ones and in its region
}

TEST(checks_section, does_not_count_what_lies_outside_validity_as_passed) {
  CheckTable table = bgl1().results.checks;
  for (CheckRow& row : table.rows) {
    if (row.id == "dnv_load_controlled" && row.region == CheckRegion::sagbend)
      row.status = CheckStatus::outside_validity;
  }
  EXPECT_NE(section_text(table).find("1 outside the validity"), std::string::npos);
}

TEST(checks_section, is_absent_without_checks) {
  EXPECT_TRUE(checks_section(bgl1().results, CheckTable{}).empty());
  EXPECT_TRUE(checks_figure_data(bgl1().results, CheckTable{}).is_null());
}

TEST(checks_section, stands_before_the_figures_of_the_report) {
  const std::string body = json_text(report_document(bgl1().results, bgl1().model_text).body.json());
  ASSERT_NE(body.find("\"id\":\"checks\""), std::string::npos);
  EXPECT_LT(body.find("\"id\":\"checks\""), body.find("\"id\":\"figures\""));
}

}  // namespace
}  // namespace overbend
