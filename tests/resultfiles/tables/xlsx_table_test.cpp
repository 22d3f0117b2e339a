#include "resultfiles/tables/xlsx_table.h"

#include <gtest/gtest.h>

#include <limits>

#include "resultfiles/tables/data_table.h"
#include "runstore/append_file.h"
#include "support/solved_case.h"
#include "support/zip_text.h"

namespace overbend {
namespace {

Table small_table() {
  Table table{"lay table: 1/2", {TableColumn("row"), {"top tension", "N", 1}, TableColumn("verdict")}};
  table.row({"step", 251.25e3, VerdictCell{VerdictKind::passed, "passed"}});
  table.row({"a & b", std::numeric_limits<double>::quiet_NaN(), VerdictCell{VerdictKind::exceeded, "exceeded"}});
  table.row({"empty", TableCell(), VerdictCell{VerdictKind::exceeded, "no lay"}});
  return table;
}

std::map<std::string, std::string> read_parts(const Table& table) {
  const testing::TemporaryFolder folder;
  write_xlsx({table}, folder / "table.xlsx");
  return testing::zip_texts(testing::file_text(folder / "table.xlsx"));
}

}  // namespace

TEST(xlsx_table, numbers_are_numbers_and_texts_are_shared_texts) {
  const auto parts = read_parts(small_table());
  const std::string& sheet = parts.at("xl/worksheets/sheet1.xml");
  EXPECT_NE(sheet.find("<v>251.25</v>"), std::string::npos);
  EXPECT_EQ(sheet.find("nan"), std::string::npos);
  EXPECT_EQ(sheet.find("r=\"B4\""), std::string::npos);  // an empty cell is not there
  const std::string& texts = parts.at("xl/sharedStrings.xml");
  for (const char* text : {"top tension [kN]", "a &amp; b", "passed", "exceeded", "no lay"}) {
    EXPECT_NE(texts.find(text), std::string::npos) << text;
  }
}

TEST(xlsx_table, head_is_frozen_and_columns_have_their_decimals) {
  const auto parts = read_parts(small_table());
  EXPECT_NE(parts.at("xl/worksheets/sheet1.xml").find("state=\"frozen\""), std::string::npos);
  EXPECT_NE(parts.at("xl/styles.xml").find("formatCode=\"0.0\""), std::string::npos);
  EXPECT_NE(parts.at("xl/workbook.xml").find("name=\"lay table  1 2\""), std::string::npos);
}

TEST(xlsx_table, the_same_table_gives_the_same_bytes) {
  const testing::TemporaryFolder folder;
  Table second = small_table();
  second.title = "second";
  for (const char* name : {"a.xlsx", "b.xlsx"}) write_xlsx({small_table(), second}, folder / name);
  EXPECT_EQ(testing::file_text(folder / "a.xlsx"), testing::file_text(folder / "b.xlsx"));
  EXPECT_EQ(testing::zip_texts(testing::file_text(folder / "a.xlsx")).at("docProps/core.xml").find("2026"),
            std::string::npos);
  EXPECT_FALSE(std::filesystem::exists(folder / "a.xlsx.part"));
}

TEST(xlsx_table, a_folder_that_is_not_there_is_an_error_of_the_file) {
  EXPECT_THROW(write_xlsx({small_table()}, "/no/such/folder/table.xlsx"), FileError);
}

TEST(data_table, csv_has_the_cells_of_the_workbook) {
  EXPECT_EQ(csv_text(small_table()),
            "row,top tension [kN],verdict\r\nstep,251.25,passed\r\na & b,,exceeded\r\nempty,,no lay\r\n");
}

}  // namespace overbend
