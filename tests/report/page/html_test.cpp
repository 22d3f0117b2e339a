#include "report/page/html.h"

#include <gtest/gtest.h>

#include <limits>

namespace overbend::html {

TEST(html, escaped_text_holds_no_markup) {
  EXPECT_EQ(escape("a<b> & \"c\" 'd'"), "a&lt;b&gt; &amp; &quot;c&quot; &#39;d&#39;");
}

TEST(html, escaped_json_can_not_end_its_script) {
  EXPECT_EQ(escape_json(R"({"a":"</script><!--"})"), R"({"a":"\u003c/script>\u003c!--"})");
}

TEST(html, a_number_that_rounds_to_zero_has_no_sign) {
  EXPECT_EQ(fixed(-0.004, 2), "0.00");
  EXPECT_EQ(fixed(-0.006, 2), "-0.01");
  EXPECT_EQ(fixed(-0.0, 0), "0");
  EXPECT_EQ(fixed(1234.5678, 1), "1234.6");
}

TEST(html, what_is_not_finite_is_a_dash) {
  EXPECT_EQ(fixed(std::numeric_limits<double>::infinity(), 2), "-");
  EXPECT_EQ(fixed(std::numeric_limits<double>::quiet_NaN(), 2), "-");
}

TEST(html, a_tile_escapes_its_words_and_sets_long_values_smaller) {
  EXPECT_NE(tile("<b>", "1", "kN", "&").find("<div class=\"name\">&lt;b&gt;</div><div class=\"value\">1 "),
            std::string::npos);
  EXPECT_NE(tile("a", "222.1 to 280.6", "kN", "").find("class=\"value long\""), std::string::npos);
}

TEST(html, cells_of_a_table_are_escaped_and_words_set_flush_left) {
  const std::string text = Table("c&d", {{"Name", "", true}, {"X", "m"}}).row({"<i>", "1.0"}).str();
  EXPECT_NE(text.find("<caption>c&amp;d</caption>"), std::string::npos);
  EXPECT_NE(text.find("<td class=\"t\">&lt;i&gt;</td><td>1.0</td>"), std::string::npos);
  EXPECT_NE(text.find("<span class=\"unit\">m</span>"), std::string::npos);
}

}  // namespace overbend::html
