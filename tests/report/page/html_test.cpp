#include "report/page/html.h"

#include <gtest/gtest.h>

namespace overbend::html {

TEST(html, escaped_text_holds_no_markup) {
  EXPECT_EQ(escape("a<b> & \"c\" 'd'"), "a&lt;b&gt; &amp; &quot;c&quot; &#39;d&#39;");
}

TEST(html, escaped_json_can_not_end_its_script) {
  EXPECT_EQ(escape_json(R"({"a":"</script><!--"})"), R"({"a":"\u003c/script>\u003c!--"})");
}

TEST(html, a_table_for_readers_without_scripts_has_units_and_the_decimals_of_its_columns) {
  Table table{"a<b", {TableColumn("Name"), TableColumn("Tension", "N", 1), TableColumn::texts("Range")}};
  table.row({"c&d", 12'345.0, "1 to 2"});
  Document document;
  document.front = {{"kind", "k"}, {"title", "t"}, {"entries", Json::array()}, {"findings", Json::array()}};
  document.body = block::section("results", "Key results", table) + block::section("other", "Other", table);
  const std::string text = plain(document);
  EXPECT_NE(text.find("<caption>a&lt;b</caption>"), std::string::npos);
  EXPECT_NE(text.find("<th>Tension [kN]</th>"), std::string::npos);
  EXPECT_NE(text.find("<tr><td>c&amp;d</td><td>12.3</td><td>1 to 2</td></tr>"), std::string::npos);
  EXPECT_EQ(text.find("Other"), std::string::npos);
}

}  // namespace overbend::html
