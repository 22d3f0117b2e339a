// Keys of the lay route: what they fill, and what the reader rejects.
#include <gtest/gtest.h>

#include "modelfile/model_texts.h"
#include "modelfile/reading/yaml_reader.h"

namespace overbend {
namespace {

ModelReading with_route(const std::string& route) {
  return read_model_text(testing::kGoodModel + "\nroute: " + route + "\n", "route.yaml");
}

Description read_route_model(const std::string& route) {
  const ModelReading reading = with_route(route);
  for (const std::string& line : reading.diagnostics.lines(Severity::error)) ADD_FAILURE() << line;
  return reading.description.value_or(Description{});
}

/// The one complaint, which names the key and says what is wrong.
void expect_complaint(const std::string& route, const std::string& key, const std::string& message) {
  const std::vector<std::string> errors = with_route(route).diagnostics.lines(Severity::error);
  ASSERT_EQ(errors.size(), 1U) << route;
  EXPECT_NE(errors.front().find(key), std::string::npos) << errors.front();
  EXPECT_NE(errors.front().find(message), std::string::npos) << errors.front();
  EXPECT_NE(errors.front().find("route.yaml:"), std::string::npos) << errors.front();
}

TEST(route_keys, fill_legs_and_points_in_si) {
  const RouteDescription legs = read_route_model("{legs: [{length: 0.4 km}, {radius: 800 m, angle: -90 deg}]}").route;
  ASSERT_EQ(legs.legs.size(), 2U);
  EXPECT_EQ(legs.legs[0].length, 400.0);
  EXPECT_EQ(legs.legs[1].radius, 800.0);
  EXPECT_NEAR(legs.legs[1].angle, -1.5707963267948966, 1e-15);
  const RouteDescription points =
      read_route_model("{points: [{x: 500 m, y: 0 m}, {x: 900 m, y: -200 m}], corner_radius: 300 m}").route;
  ASSERT_EQ(points.points.size(), 2U);
  EXPECT_EQ(points.points[1].y, -200.0);
  EXPECT_EQ(points.corner_radius, 300.0);
  EXPECT_FALSE(read_route_model("{points: [{x: 500 m, y: 0 m}]}").route.legs.size());
}

TEST(route_keys, static_settings_name_laying_and_roller_friction) {
  std::string text = testing::kGoodModel;
  const std::string before = "static: {method: newton,";
  text.replace(text.find(before), before.size(), before + " laying: static, roller_friction: haul,");
  const ModelReading reading = read_model_text(text, "route.yaml");
  ASSERT_TRUE(reading.description);
  EXPECT_EQ(reading.description->statics.laying, SeabedLayHistory::pulled_sideways);
  EXPECT_EQ(reading.description->statics.roller_friction, RollerFriction::haul);
  EXPECT_EQ(StaticSettings{}.laying, SeabedLayHistory::steady);
}

TEST(route_keys, reject_what_is_no_route) {
  expect_complaint("{legs: [{length: 400 m, radius: 800 m, angle: 5 deg}]}", "route.legs[0]", "a length, or a radius");
  expect_complaint("{legs: [{radius: 800 m}]}", "route.legs[0]", "only one of radius and angle");
  expect_complaint("{legs: [{radius: 800 m, angle: 0 deg}]}", "route.legs[0].angle", "positive to port");
  expect_complaint("{legs: [{length: 400 m}], points: [{x: 5 m, y: 0 m}]}", "route.legs", "points or legs");
  expect_complaint("{corner_radius: 300 m}", "route", "neither points nor legs");
  expect_complaint("{points: [{x: 500 m, y: 3 m}]}", "route.points[0].y", "straight astern");
  expect_complaint("{points: [{x: -5 m, y: 0 m}]}", "route.points[0].x", "stern shoe");
  expect_complaint("{points: [{x: 50 m, y: 0 m}, {x: 90 m, y: 40 m}], corner_radius: 300 m}", "route.corner_radius",
                   "arcs that fit");
  expect_complaint("{points: [{x: 50 m, y: 0 m}, {x: 10 m, y: 1 m}]}", "route.points[0]", "170 degrees");
}

}  // namespace
}  // namespace overbend
