// Lay tables of the page.
#include <cstdlib>

#include "serve/serving.h"

namespace overbend {
namespace {

using testing::Serving;

TEST(serve_lay_table, its_spreadsheet_needs_no_folder_for_temporary_files) {
  const Serving serving(testing::kSmallLay);
  const Json range = {{"vary", "tension"}, {"range", "300 kN..310 kN/10"}};
  EXPECT_EQ(serving.get("/api/lay-table.xlsx").status, 404);
  ASSERT_EQ(serving.post("/api/lay-table", range).status, 200);
  const char* before = std::getenv("TMPDIR");
  const std::string kept = before != nullptr ? before : "";
  ::setenv("TMPDIR", "/no/such/folder", 1);
  const testing::Reply book = serving.get("/api/lay-table.xlsx");
  before != nullptr ? ::setenv("TMPDIR", kept.c_str(), 1) : ::unsetenv("TMPDIR");
  EXPECT_EQ(book.status, 200) << book.body;
  EXPECT_TRUE(book.body.starts_with("PK"));
  EXPECT_TRUE(serving.get("/api/lay-table.csv").body.starts_with("row,tension [kN]"));
}

}  // namespace
}  // namespace overbend
