#include <gtest/gtest.h>

#include "serve/answers/type_style.h"
#include "support/solved_case.h"

namespace overbend {
namespace {

TEST(page_types, of_the_page_are_those_of_the_program) {
  EXPECT_EQ(testing::file_text(std::string(OVERBEND_SOURCE_DIR) + "/web/src/api/results.ts"), page_types())
      << "run: build/release/overbend schema --types > web/src/api/results.ts";
}

TEST(page_types, are_written_as_typescript_has_them) {
  EXPECT_EQ(type_text(Json::array({"number"})), "number[]");
  EXPECT_EQ(type_text(Json::array({"'a' | 'b'"})), "('a' | 'b')[]");
  EXPECT_EQ(type_text(Json{{"at", {{"s", "number"}}}, {"note?", "string"}}), "{ at: { s: number; }; note?: string; }");
}

}  // namespace
}  // namespace overbend
