#include "seafiles/column_title.h"

#include <gtest/gtest.h>

#include "base/constants.h"

namespace overbend {
namespace {

TEST(column_title, has_its_unit_after_an_underscore_in_brackets_or_after_a_comma) {
  for (const char* title : {"heave_m", "Heave [m]", "HEAVE (m)", "Heave, m", "HEAVE_M"}) {
    const ColumnTitle parsed = parse_column_title(title);
    EXPECT_EQ(parsed.name, "heave") << title;
    EXPECT_EQ(parsed.unit.empty() ? ' ' : std::tolower(parsed.unit[0]), 'm') << title;
  }
  EXPECT_EQ(parse_column_title("time (Unix, s)").remark, "unix");
  EXPECT_EQ(parse_column_title("time (Unix, s)").unit, "s");
}

TEST(column_title, without_a_unit_is_a_name) {
  for (const char* title : {"roll", "roll_a", "water_depth", "Heave, corrected", "(m)", "", "_m"}) {
    EXPECT_EQ(parse_column_title(title).unit, "") << title;
  }
  EXPECT_EQ(parse_column_title("Water_Depth").name, "water_depth");
}

TEST(column_title, units_are_those_of_the_dimension) {
  EXPECT_EQ(title_unit_factor("cm", "m"), 0.01);
  EXPECT_EQ(title_unit_factor("\xc2\xb0", "rad"), kDegree);
  EXPECT_EQ(title_unit_factor("DEG", "rad"), kDegree);
  EXPECT_EQ(title_unit_factor("ms", "s"), 1e-3);
  EXPECT_FALSE(title_unit_factor("deg", "m"));
  EXPECT_FALSE(title_unit_factor("", "m"));
  EXPECT_FALSE(title_unit_factor(std::string(500, 'm'), "m"));
}

TEST(column_title, a_cell_of_a_line_of_units_is_a_unit_alone) {
  for (const char* cell : {"m", "[deg]", "(s)", "-", "m/s", "hh:mm:ss.000", "yyyy-mm-dd hh:mm:ss"}) {
    EXPECT_TRUE(is_unit_cell(cell)) << cell;
  }
  for (const char* cell : {"0.5", "heave", "", "12:00:00"}) EXPECT_FALSE(is_unit_cell(cell)) << cell;
}

}  // namespace
}  // namespace overbend
