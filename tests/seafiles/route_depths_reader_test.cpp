#include "seafiles/route_depths_reader.h"

#include <gtest/gtest.h>

namespace overbend {
namespace {

std::string read_error(const std::string& text) {
  Diagnostics diagnostics;
  EXPECT_TRUE(read_route_depths_text(text, "route.csv", diagnostics).empty());
  const std::vector<std::string> lines = diagnostics.lines(Severity::error);
  return lines.empty() ? "" : lines.front();
}

}  // namespace

TEST(route_depths_reader, takes_kilometre_points_and_distances) {
  Diagnostics diagnostics;
  const auto points = read_route_depths_text("# survey\nkp_km,depth_m\n0,60\n1.5,72.5\n", "route.csv", diagnostics);
  ASSERT_EQ(points.size(), 2U);
  EXPECT_DOUBLE_EQ(points[1].distance, 1500.0);
  EXPECT_DOUBLE_EQ(points[1].depth, 72.5);
  const auto metres = read_route_depths_text("distance_m,depth_m\n10,60\n", "route.csv", diagnostics);
  EXPECT_DOUBLE_EQ(metres.at(0).distance, 10.0);
  EXPECT_FALSE(diagnostics.has_errors());
}

TEST(route_depths_reader, takes_the_layouts_of_spreadsheets) {
  Diagnostics diagnostics;
  const auto points =
      read_route_depths_text("Elevation [m];KP [km];Note\r\n-60,5;0;a\r\n-72,5;1,5;\r\n", "route.csv", diagnostics);
  ASSERT_EQ(points.size(), 2U) << diagnostics.lines(Severity::error).front();
  EXPECT_DOUBLE_EQ(points[1].distance, 1500.0);
  EXPECT_DOUBLE_EQ(points[1].depth, 72.5);
  EXPECT_NE(read_error("kp_km,elevation_m\n0,60\n").find("less than 0"), std::string::npos);
}

TEST(route_depths_reader, says_line_and_reason_of_an_error) {
  EXPECT_NE(read_error("kp,depth\n0,60\n").find("route.csv:1"), std::string::npos);
  EXPECT_NE(read_error("kp_km,depth_m\n0,60\n0,61\n").find("more than the previous distance"), std::string::npos);
  EXPECT_NE(read_error("kp_km,depth_m\n0,deep\n").find("route.csv:2"), std::string::npos);
  EXPECT_NE(read_error("kp_km,depth_m\n0,-3\n").find("more than 0"), std::string::npos);
  EXPECT_NE(read_error("kp_km,depth_m\n").find("a row per point"), std::string::npos);
  EXPECT_NE(read_error("").find("empty"), std::string::npos);
}

}  // namespace overbend
