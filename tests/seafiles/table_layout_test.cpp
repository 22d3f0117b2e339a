#include "seafiles/table_layout.h"

#include <gtest/gtest.h>

#include "support/table_cases.h"

namespace overbend {
namespace {

using Cells = std::vector<std::string_view>;

/// The table of a text that outlives it.
struct Reading {
  explicit Reading(std::string given)
      : text(std::move(given)), table(read_exported_table(text, "t.csv", diagnostics)) {}
  std::string text;
  Diagnostics diagnostics;
  std::optional<ExportedTable> table;
};

void expect_cells(const char* text, char separator, const Cells& header, const Cells& row) {
  const Reading reading(text);
  ASSERT_TRUE(reading.table) << text;
  EXPECT_EQ(reading.table->separator, separator) << text;
  ASSERT_GE(reading.table->rows.size(), 2U) << text;
  EXPECT_EQ(reading.table->rows[0].cells, header) << text;
  EXPECT_EQ(reading.table->rows[1].cells, row) << text;
}

std::string layout_error(const char* text) {
  const Reading reading(text);
  EXPECT_FALSE(reading.table) << text;
  return testing::all_messages(reading.diagnostics);
}

TEST(table_layout, recognises_commas_semicolons_tabs_and_blanks) {
  expect_cells("a,b,c\n1, 2.5 ,3\n", ',', {"a", "b", "c"}, {"1", "2.5", "3"});
  expect_cells("a;b;c\r\n1;2.5;3\r\n", ';', {"a", "b", "c"}, {"1", "2.5", "3"});
  expect_cells("a\tb\tc\n1\t2.5\t3\n", '\t', {"a", "b", "c"}, {"1", "2.5", "3"});
  expect_cells("  a  b   c\n  1 2.5\t3\n", ' ', {"a", "b", "c"}, {"1", "2.5", "3"});
  expect_cells("sep=;\na;b\n1;2\n", ';', {"a", "b"}, {"1", "2"});
  expect_cells("time,x\n2026-06-01 09:00:00,2\n", ',', {"time", "x"}, {"2026-06-01 09:00:00", "2"});
}

TEST(table_layout, reads_decimal_commas_where_the_comma_does_not_separate) {
  expect_cells("a;b\n0,5;-1,25e3\n", ';', {"a", "b"}, {"0.5", "-1.25e3"});
  expect_cells("a\tb\n0,5\t1\n", '\t', {"a", "b"}, {"0.5", "1"});
  expect_cells("500000,12 6000000,5 -45,2\n500010,12 6000000,5 -45,3\n", ' ', {"500000.12", "6000000.5", "-45.2"},
               {"500010.12", "6000000.5", "-45.3"});
  const Reading reading("a;b\n0,5;1,5\n");
  EXPECT_TRUE(reading.table->decimal_comma);
  EXPECT_NE(testing::all_messages(reading.diagnostics).find("decimal commas"), std::string::npos);
}

TEST(table_layout, rejects_commas_and_points_that_mean_either) {
  EXPECT_NE(layout_error("a;b\n0,5;1\n0.5;1\n").find("t.csv:3: found '0,5' and '0.5', expected one decimal sign"),
            std::string::npos);
  EXPECT_NE(layout_error("a\tb\n12,345\t1\n").find("thousands"), std::string::npos);
}

TEST(table_layout, quotes_and_empty_columns_at_the_end_of_lines_are_dropped) {
  const Reading reading("\"Time, s\",\"b \"\"x\"\"\",\n\"0.5\",\"1\",\n,,\n0.6,,,\n,,,\n");
  ASSERT_TRUE(reading.table);
  ASSERT_EQ(reading.table->rows.size(), 3U);
  EXPECT_EQ(reading.table->width, 2U);
  EXPECT_EQ(reading.table->rows[0].cells[0], "Time, s");
  EXPECT_EQ(reading.table->rows[1].cells, (Cells{"0.5", "1"}));
  EXPECT_EQ(reading.table->rows[2].cells, (Cells{"0.6", ""}));
}

TEST(table_layout, a_line_of_units_belongs_to_the_header) {
  const Reading reading("# note: x\ntime\theave\tq\n[s]\t[m]\t-\n0\t1\t2\n");
  ASSERT_TRUE(reading.table);
  EXPECT_EQ(reading.table->units.cells, (Cells{"[s]", "[m]", "-"}));
  EXPECT_EQ(reading.table->rows[1].line, 4);
  EXPECT_EQ(reading.table->remarks.at(0).cells, (Cells{"note", "x"}));
  EXPECT_EQ(reading.table->unit(7), "");
}

TEST(table_layout, a_first_row_of_numbers_is_no_header) {
  EXPECT_FALSE(Reading("1 2 3\n4 5 6\n").table->has_header);
  EXPECT_TRUE(Reading("x y z\n4 5 6\n").table->has_header);
  EXPECT_TRUE(Reading("").table->rows.empty());
}

TEST(table_layout, hints_at_decimal_commas_between_commas) {
  const Reading reading("a,b\n0,5,1,5\n0,6,1,7\n");
  EXPECT_NE(row_width_hint(*reading.table, reading.table->rows[1]).find("semicolons or tabs"), std::string::npos);
  const Reading letters("a,b\nx,y,z\n");
  EXPECT_EQ(row_width_hint(*letters.table, letters.table->rows[1]), "");
}

}  // namespace
}  // namespace overbend
