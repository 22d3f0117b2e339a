#include "resultfiles/static/span_table.h"

#include <gtest/gtest.h>

namespace overbend {
namespace {

TEST(span_table, has_a_row_per_span_in_engineering_units) {
  BedResults bed;
  bed.spans.push_back({180.5, 228.25, 300.0, 252.0, 48.0, 1.25, 217.75, 440e3, 185.0, 87e6});
  const std::string text = span_table(bed);
  EXPECT_EQ(text.substr(0, text.find("\r\n")),
            "from [m],to [m],length [m],largest gap [m],gap at [m],sagging moment [kN m],moment at [m],"
            "bending stress [MPa]");
  EXPECT_NE(text.find("\r\n180.5,228.25,48,1.25,217.75,440,185,87\r\n"), std::string::npos) << text;
}

TEST(span_table, without_spans_is_its_head) {
  const std::string text = span_table(BedResults{});
  EXPECT_EQ(text.find("\r\n"), text.size() - 2);
}

}  // namespace
}  // namespace overbend
