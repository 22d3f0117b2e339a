#include "resultfiles/static/check_tables.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "resultfiles/summary/summary_fields.h"
#include "support/solved_case.h"

namespace overbend {
namespace {

using testing::solved_case;

TEST(check_tables, csv_has_a_row_per_check_and_no_numbers_where_it_is_not_done) {
  const CheckTable& table = solved_case("BGL1-T250").results.checks;
  const std::string text = checks_table(table);
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), static_cast<long>(table.rows.size()) + 1);
  const std::size_t index = text.find("Laying criterion II");
  ASSERT_NE(index, std::string::npos);
  const std::string line = text.substr(index, text.find("\r\n", index) - index);
  EXPECT_NE(line.find("not done,yes,,,longitudinal strain,,,%,,,,,,,needs a dynamic analysis"), std::string::npos)
      << line;
  EXPECT_NE(text.find("M_Sd = "), std::string::npos);
}

TEST(check_tables, csv_speaks_the_units_of_the_other_tables) {
  CheckTable table;
  CheckRow row;
  row.status = CheckStatus::passed;
  row.quantity = "design moment";
  row.units = "N m";
  row.demand = 424836.0;
  row.capacity = 1e6;
  row.inputs = {
      {"t2", "wall", 0.0127, "m"}, {"eps", "strain", 0.0023, "1"}, {"gamma", "strain resistance factor", 2.0, "1"}};
  table.rows = {row};
  const std::string text = checks_table(table);
  EXPECT_NE(text.find(",design moment,424.836,1000,kN m,"), std::string::npos) << text;
  EXPECT_NE(text.find("t2 = 12.7 mm; eps = 0.23 %; gamma = 2\r\n"), std::string::npos) << text;
}

TEST(check_tables, the_calculation_sheet_has_a_row_per_line_with_values_in_si) {
  CheckTable table;
  CheckRow& row = table.rows.emplace_back();
  row.name = "Burst";
  row.code = "Code (2021)";
  row.clause = "5.4.2";
  row.s = 12.5;
  row.sheet = {{"f_y", "strength", "", 430e6, "Pa", "5.3.3", Confirmation::two_sources, "A; B"},
               {"p_b", "pressure", "f_y 2/sqrt(3)", 0.5e9, "Pa", "5.4.2", Confirmation::unconfirmed, ""}};
  const std::string text = calculation_sheet_table(table);
  EXPECT_EQ(text,
            "check,code,clause,region,s [m],symbol,meaning,formula,value,units,origin,confirmation,sources,line\r\n"
            "Burst,Code (2021),5.4.2,line,12.5,f_y,strength,,430000000,Pa,5.3.3,two or more sources,A; B,\r\n"
            "Burst,Code (2021),5.4.2,line,12.5,p_b,pressure,f_y 2/sqrt(3),500000000,Pa,5.4.2,unconfirmed,,\r\n");
  row.line = "west pipe";
  const std::string staged = calculation_sheet_table({{"raised", table}});
  EXPECT_EQ(staged.find("stage,check,code"), 0u);
  EXPECT_NE(staged.find("raised,Burst,Code (2021),5.4.2,line,12.5,f_y,strength,,430000000,Pa,5.3.3,"
                        "two or more sources,A; B,west pipe\r\n"),
            std::string::npos);
}

TEST(check_tables, json_names_the_worst_and_leaves_out_what_is_not_done) {
  const CheckTable& table = solved_case("BGL1-T250").results.checks;
  const auto json = summary_checks(SummaryStyle{}, table);
  EXPECT_EQ(json["list"].size(), table.rows.size());
  EXPECT_EQ(json["worst"]["utilisation"].get<double>(), find_governing_check(table)->utilisation);
  for (const auto& row : json["list"]) {
    EXPECT_EQ(row.contains("utilisation"), row["status"] != "not done") << row["id"];
  }
}

TEST(check_tables, without_checks_there_is_no_worst) {
  EXPECT_TRUE(summary_checks(SummaryStyle{}, CheckTable{})["worst"].is_null());
}

}  // namespace
}  // namespace overbend
