#include "report/static/criteria_section.h"

#include <gtest/gtest.h>

#include "report/page_text.h"

namespace overbend {
namespace {

using testing::count;
using testing::shown_text;

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
  const std::string text = shown_text(criteria_section(table, std::nullopt));
  EXPECT_EQ(count(text, "Equivalent stress"), 1U);
  EXPECT_LT(text.find("Equivalent stress"), text.find("soft: Propagation"));
  EXPECT_EQ(count(text, "| decides\n"), 1U);
  EXPECT_EQ(count(text, "| information\n"), 1U);
  EXPECT_TRUE(criteria_section({}, std::nullopt).empty());
}

TEST(criteria_section, names_the_findings_that_the_project_accepts) {
  CheckTable table;
  table.rows.emplace_back().name = "Roller force";
  Description description;
  description.checks.accepted_findings = {"pipe-off-rollers"};
  EXPECT_EQ(count(shown_text(criteria_section(table, description)), "by the project: pipe-off-rollers."), 1U);
  EXPECT_EQ(count(shown_text(criteria_section(table, Description{})), "accepted by the project"), 0U);
}

}  // namespace
}  // namespace overbend
