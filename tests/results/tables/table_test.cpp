#include "results/tables/table.h"

#include <gtest/gtest.h>

#include <limits>

#include "support/us_units.h"

namespace overbend {
namespace {

Table short_table() {
  Table table{"Lines", {TableColumn("Line"), TableColumn("Tension", "N", 1), TableColumn("Angle", "rad", 2)}};
  table.row({"S1", 346'612.3, 0.1}).row({"a long name", std::optional<double>(), -0.00001}, RowMark::over);
  return table;
}

TEST(table, as_text_has_heads_with_units_and_columns_that_stand_below_each_other) {
  EXPECT_EQ(table_text(short_table()),
            "  Line         Tension kN  Angle deg\n"
            "  S1                346.6       5.73\n"
            "  a long name                   0.00\n");
}

TEST(table, as_data_has_values_in_the_units_shown_with_four_decimals_more) {
  const Json json = table_json(short_table());
  EXPECT_EQ(json["columns"][1], Json({{"title", "Tension"}, {"unit", "kN"}, {"digits", 1}}));
  EXPECT_EQ(json["rows"][0], Json({"S1", 346.6123, 5.729578}));
  EXPECT_EQ(json["rows"][1], Json({"a long name", nullptr, -0.000573}));
  EXPECT_EQ(json["marks"], Json({"", "over"}));
  EXPECT_FALSE(json.contains("groups"));
}

TEST(table, in_customary_units_loses_no_digit) {
  const UsUnits units;
  const Table table = Table{"", {TableColumn("Tension", "N", 1)}}.row({4448.2216152605});
  EXPECT_EQ(cell_text(table.columns[0], table.rows[0].cells[0]), "1.00");
  EXPECT_EQ(title_with_unit(table.columns[0]), "Tension [kip]");
}

TEST(table, what_is_not_finite_is_a_dash) {
  const Table table = Table{"", {TableColumn("X", "m", 2)}}.row({std::numeric_limits<double>::infinity()});
  EXPECT_EQ(cell_text(table.columns[0], table.rows[0].cells[0]), "-");
  EXPECT_EQ(table_json(table)["rows"][0][0], "-");
}

TEST(table, has_a_narrow_form_of_the_columns_that_are_named) {
  Table table{"", {TableColumn("A"), TableColumn("B", "m", 1), TableColumn("C", "m", 1)}};
  table.columns[0].key = "a";
  table.columns[2].key = "c";
  table.row({"x", 1.0, 2.0}, RowMark::over);
  const Table narrow = table.with_columns({"c", "none", "a"});
  EXPECT_EQ(table_json(narrow)["rows"], Json::array({Json::array({2.0, "x"})}));
  EXPECT_EQ(narrow.rows[0].mark, RowMark::over);
}

TEST(table, columns_that_say_nothing_can_be_left_out_and_the_heads_above_follow) {
  Table table{"", {TableColumn("A"), TableColumn("B", "m", 1), TableColumn("C", "m", 1)}};
  table.groups({{"", 1}, {"Both", 2}});
  table.row({"a", std::optional<double>(), 1.0}).row({"b", "", 2.0}).drop_empty_columns();
  ASSERT_EQ(table.columns.size(), 2u);
  EXPECT_EQ(table.rows[1].cells.size(), 2u);
  EXPECT_EQ(table_json(table)["groups"], Json::array({Json::array({"", 1}), Json::array({"Both", 1})}));
}

}  // namespace
}  // namespace overbend
