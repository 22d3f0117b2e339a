#include "report/static/friction_section.h"

#include <gtest/gtest.h>

namespace overbend {
namespace {

TEST(friction_section, is_empty_where_nothing_pushes_aside_and_nothing_rubs) {
  EXPECT_EQ(friction_section(StaticResults{}), "");
}

TEST(friction_section, says_what_the_seabed_and_the_supports_carry_and_to_which_side) {
  StaticResults results;
  results.route = RouteResults{};
  results.route->side_load_bed = -7.42e3;
  results.route->side_load_supports = 43.28e3;
  results.route->laid_offset = 11.104;
  const std::string text = friction_section(results);
  EXPECT_NE(text.find("What friction decides"), std::string::npos);
  EXPECT_NE(text.find("7.42 to starboard"), std::string::npos);
  EXPECT_NE(text.find("43.28 to port"), std::string::npos);
  EXPECT_NE(text.find("11.10 to port"), std::string::npos);
  EXPECT_EQ(text.find("Smallest radius"), std::string::npos);
}

TEST(friction_section, says_whether_a_bend_holds) {
  StaticResults results;
  results.route = RouteResults{800.0, 1116.0, false, 5.06, 582.8, 408.8, 0.0, 0.0, 0.0};
  const std::string text = friction_section(results);
  EXPECT_NE(text.find("800, does not hold"), std::string::npos);
  EXPECT_NE(text.find("1116"), std::string::npos);
  EXPECT_NE(text.find("408.8"), std::string::npos);
}

TEST(friction_section, lists_the_limits_in_customary_units) {
  StaticResults results;
  results.roller_friction = {{"lay", 250e3, 206.1e3, 335.0, 0.21, 0.071, 330e6, 74e6, 48e3}};
  const std::string text = friction_section(results);
  for (const char* cell : {"lay", "206.1", "335.00", "0.210", "71.0", "330.0", "48.0"}) {
    EXPECT_NE(text.find(cell), std::string::npos) << cell;
  }
}

}  // namespace
}  // namespace overbend
