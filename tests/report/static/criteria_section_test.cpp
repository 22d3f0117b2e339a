#include "report/static/criteria_section.h"

#include <gtest/gtest.h>

#include "report/page/page.h"
#include "support/solved_case.h"

namespace overbend {
namespace {

std::size_t occurrences(const std::string& text, const std::string& part) {
  std::size_t count = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++count;
  return count;
}

TEST(criteria_section, names_every_check_once_and_says_which_decide) {
  CheckTable table;
  for (const CheckRegion region : {CheckRegion::overbend, CheckRegion::sagbend}) {
    CheckRow row;
    row.id = "stress";
    row.name = "Equivalent stress, 0.87 f_y";
    row.code = "DNV-ST-F101 (2021)";
    row.region = region;
    table.rows.push_back(row);
  }
  CheckRow information;
  information.id = "propagation";
  information.name = "Propagation of a buckle";
  information.governing = false;
  table.rows.insert(table.rows.begin(), information);
  const std::string html = criteria_section(table, std::nullopt);
  EXPECT_EQ(occurrences(html, "Equivalent stress"), 1U);
  EXPECT_LT(html.find("Equivalent stress"), html.find("Propagation"));
  EXPECT_EQ(occurrences(html, "decides</td>"), 1U);
  EXPECT_EQ(occurrences(html, "information</td>"), 1U);
  EXPECT_EQ(criteria_section({}, std::nullopt), "");
}

TEST(criteria_section, names_the_findings_that_the_project_accepts) {
  CheckTable table;
  table.rows.emplace_back().name = "Roller force";
  Description description;
  description.checks.accepted_findings = {"pipe-off-rollers"};
  EXPECT_NE(criteria_section(table, description).find("pipe-off-rollers"), std::string::npos);
  EXPECT_EQ(criteria_section(table, Description{}).find("accepted by the project"), std::string::npos);
}

TEST(page_margins, hold_document_title_and_date_and_cannot_leave_their_style) {
  const std::string style =
      page_margins({"OB-1, rev. B", "a \"lay\" </style>", "Static analysis", "2026-11-29 00:30 UTC"});
  EXPECT_NE(style.find("\"OB-1, rev. B\""), std::string::npos) << style;
  EXPECT_NE(style.find("Static analysis, 2026-11-29 00:30 UTC"), std::string::npos) << style;
  EXPECT_EQ(occurrences(style, "</style>"), 1U) << style;
  EXPECT_EQ(style.find("\"lay\""), std::string::npos) << style;
}

}  // namespace
}  // namespace overbend
