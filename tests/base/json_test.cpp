#include "base/json.h"

#include <gtest/gtest.h>

#include <fstream>

namespace overbend {
namespace {

/// A file of the running test's own: others may run at the same time.
std::filesystem::path written(const std::string& text) {
  const std::string name = ::testing::UnitTest::GetInstance()->current_test_info()->name();
  const std::filesystem::path file = ::testing::TempDir() + "json_test." + name + ".json";
  std::ofstream(file, std::ios::binary) << text;
  return file;
}

TEST(json, members_stand_in_the_order_in_which_they_came) {
  EXPECT_EQ(json_text(read_json(R"({"z": 1, "a": [2, null]})")), R"({"z":1,"a":[2,null]})");
}

TEST(json, is_indented_where_asked_for) {
  EXPECT_EQ(json_text({{"a", 1}}, 2), "{\n  \"a\": 1\n}");
}

TEST(json, bytes_that_are_no_utf8_are_replaced) {
  EXPECT_EQ(json_text(Json("m\xff")), "\"m\xEF\xBF\xBD\"");
}

TEST(json, a_text_that_is_none_throws) {
  EXPECT_THROW(read_json("{"), Json::parse_error);
}

TEST(json, a_file_that_is_there_is_read) {
  EXPECT_EQ(read_json_file(written(R"({"a": 1})"))["a"], 1);
}

TEST(json, a_file_that_is_none_or_absent_is_null) {
  EXPECT_TRUE(read_json_file(written("{")).is_null());
  EXPECT_TRUE(read_json_file("no such file").is_null());
}

TEST(json, an_object_is_asked_for_by_name) {
  EXPECT_TRUE(read_json_object(written("{}")).has_value());
  EXPECT_FALSE(read_json_object(written("[1]")).has_value());
  EXPECT_FALSE(read_json_object("no such file").has_value());
}

}  // namespace
}  // namespace overbend
