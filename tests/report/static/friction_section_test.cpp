#include "report/static/friction_section.h"

#include <gtest/gtest.h>

#include "report/page_text.h"

namespace overbend {
namespace {

void expect_parts(const std::string& text, std::initializer_list<const char*> parts) {
  for (const char* part : parts) EXPECT_NE(text.find(part), std::string::npos) << part << " in\n" << text;
}

TEST(friction_section, is_empty_where_nothing_pushes_aside_and_nothing_rubs) {
  EXPECT_TRUE(friction_section(StaticResults{}).empty());
}

TEST(friction_section, says_what_the_seabed_and_the_supports_carry_and_to_which_side) {
  StaticResults results;
  results.route = RouteResults{};
  results.route->side_load_bed = -7.42e3;
  results.route->side_load_supports = 43.28e3;
  results.route->laid_offset = 11.104;
  const std::string text = testing::shown_text(friction_section(results));
  expect_parts(text, {"Effect of roller friction", "Touchdown offset from the route [m] | 11.10 to port",
                      "Side load on the seabed [kN] | 7.42 to starboard", " | 43.28 to port"});
  EXPECT_EQ(text.find("Minimum radius"), std::string::npos);
}

TEST(friction_section, says_whether_a_bend_holds) {
  StaticResults results;
  results.route = RouteResults{800.0, 1116.0, false, 5.06, 582.8, 408.8, 0.0, 0.0, 0.0};
  expect_parts(testing::shown_text(friction_section(results)), {" | 800, not stable", " | 1116", " | 408.8"});
}

TEST(friction_section, lists_the_limits_in_customary_units) {
  StaticResults results;
  results.roller_friction = {{"lay", 250e3, 206.1e3, 335.0, 0.21, 0.071, 330e6, 74e6, 48e3}};
  expect_parts(testing::shown_text(friction_section(results)),
               {"lay | 250.0 | 206.1 | 335.00 | 0.210 | 71.0 | 330.0 | 74.0 | 48.0"});
}

}  // namespace
}  // namespace overbend
