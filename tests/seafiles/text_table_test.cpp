#include "seafiles/text_table.h"

#include <gtest/gtest.h>

#include <filesystem>

#include "support/rao_files.h"

namespace overbend {
namespace {

using Cells = std::vector<std::string_view>;

TEST(text_table, splits_and_trims_and_counts_the_lines_of_the_file) {
  const TextTable table = split_table("a, b ,c\r\n\n  1,,3\n4,5,\n", ',');
  ASSERT_EQ(table.rows.size(), 3U);
  EXPECT_EQ(table.rows[0].cells, (Cells{"a", "b", "c"}));
  EXPECT_EQ(table.rows[1].line, 3);
  EXPECT_EQ(table.rows[1].cells, (Cells{"1", "", "3"}));
  EXPECT_EQ(table.rows[2].cells, (Cells{"4", "5", ""}));
}

TEST(text_table, a_blank_splits_at_white_space_of_any_length) {
  const TextTable table = split_table("  1 \t 2   3\n", ' ');
  ASSERT_EQ(table.rows.size(), 1U);
  EXPECT_EQ(table.rows[0].cells, (Cells{"1", "2", "3"}));
}

TEST(text_table, remarks_are_keys_with_values_or_plain_text) {
  const TextTable table = split_table("# phase: lag\nx,y\n  # by the yard\n# time: 12:30\n", ',');
  ASSERT_EQ(table.remarks.size(), 3U);
  EXPECT_EQ(table.remarks[0].cells, (Cells{"phase", "lag"}));
  EXPECT_EQ(table.remarks[1].cells, (Cells{"by the yard"}));
  EXPECT_EQ(table.remarks[1].line, 3);
  EXPECT_EQ(table.remarks[2].cells, (Cells{"time", "12:30"}));
  EXPECT_EQ(table.rows.size(), 1U);
}

TEST(text_table, the_last_line_needs_no_end) {
  EXPECT_EQ(split_table("1,2", ',').rows.size(), 1U);
  EXPECT_TRUE(split_table("", ',').rows.empty());
}

TEST(cell_number, is_a_finite_decimal_number_and_nothing_else) {
  EXPECT_EQ(cell_number("+1.5"), 1.5);
  EXPECT_EQ(cell_number("-2e-3"), -2e-3);
  for (const char* cell : {"", "1.5 m", "1,5", "0x10", "nan", "inf", "-inf", "1e999", "+", "--1"}) {
    EXPECT_FALSE(cell_number(cell)) << cell;
  }
}

TEST(read_text_file, leaves_out_the_byte_order_mark) {
  const testing::WrittenFile file("marked.csv",
                                  "\xef\xbb\xbf"
                                  "a,b\n");
  Diagnostics diagnostics;
  EXPECT_EQ(read_text_file(file.path(), diagnostics), "a,b\n");
}

TEST(read_text_file, rejects_what_is_not_a_file) {
  for (const std::string& path : {std::string("/nowhere/a.csv"), std::filesystem::temp_directory_path().string()}) {
    Diagnostics diagnostics;
    EXPECT_FALSE(read_text_file(path, diagnostics)) << path;
    EXPECT_EQ(diagnostics.error_count(), 1) << path;
  }
}

}  // namespace
}  // namespace overbend
