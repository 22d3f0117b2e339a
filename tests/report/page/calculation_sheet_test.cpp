#include "report/page/calculation_sheet.h"

#include <gtest/gtest.h>

#include "report/bgl1_results.h"
#include "report/page/formula_text.h"
#include "report/page_text.h"
#include "report/report.h"

namespace overbend {
namespace {

using testing::bgl1;
using testing::count;

/// Two inputs and a formula of them.
std::vector<SheetLine> short_sheet() {
  return {{"f_y", "yield strength", "", 430e6, "Pa", "5.3.3", Confirmation::two_sources, "A; B"},
          {"t_2", "wall", "", 0.0111, "m", "steel.wall_thickness", Confirmation::not_needed, ""},
          {"M", "moment", "f_y (2 t_2)^2 t_2/sqrt(3)", 1.0, "N m", "5.4.6", Confirmation::unconfirmed, ""}};
}

TEST(formula_text, numbers_stand_with_their_units_in_place_of_symbols) {
  EXPECT_EQ(substituted_formula(short_sheet(), 2),
            "430\u00a0MPa \u00b7 (2 \u00b7 11.1\u00a0mm)^2 \u00b7 11.1\u00a0mm/sqrt(3)");
  EXPECT_EQ(substituted_formula(short_sheet(), 0), "");
}

TEST(formula_text, values_have_six_digits_and_no_exponent_where_that_can_be) {
  EXPECT_EQ(six_digits(0.0), "0");
  EXPECT_EQ(six_digits(1.15), "1.15");
  EXPECT_EQ(six_digits(1234567.8), "1234568");
  EXPECT_EQ(six_digits(0.0001234567), "0.000123457");
  EXPECT_EQ(six_digits(-21.4108321), "-21.4108");
  EXPECT_EQ(six_digits(2.5e-21), "2.50000e-21");
}

TEST(calculation_sheet, shows_the_most_used_row_of_each_check_with_clause_and_confirmation) {
  CheckTable table;
  for (const double used : {0.4, 0.7}) {
    CheckRow& row = table.rows.emplace_back();
    row.id = row.name = "load";
    row.code = "code";
    row.status = CheckStatus::passed;
    row.utilisation = used;
    row.sheet = short_sheet();
  }
  const std::string text = testing::shown_text(calculation_sheet_section(table));
  EXPECT_EQ(count(text, "utilisation 0.7"), 1U);
  EXPECT_EQ(count(text, "utilisation 0.4"), 0U);
  for (const char* said :
       {"5.4.6", "not confirmed", "two or more sources: A; B", "steel.wall_thickness", "11.1\u00a0mm"}) {
    EXPECT_NE(text.find(said), std::string::npos) << said;
  }
}

TEST(calculation_sheet, is_in_the_appendix_of_the_report_and_the_front_page_points_to_it) {
  const Document document = report_document(bgl1().results, bgl1().model_text);
  EXPECT_NE(testing::front_text(document.front).find(kBasisOfChecks), std::string::npos);
  const std::string sheet = testing::section_text(document, "calculation-sheet");
  EXPECT_EQ(count(sheet, "nan"), 0U);
  for (const char* clause : {"5.4.4, eq. 5.12", "5.4.5, eq. 5.21", "5.4.6", "4.3.2.2", "sec. 13"}) {
    EXPECT_NE(sheet.find(clause), std::string::npos) << clause;
  }
}

TEST(calculation_sheet, is_absent_without_sheets) {
  EXPECT_TRUE(calculation_sheet_section(CheckTable{}).empty());
}

}  // namespace
}  // namespace overbend
