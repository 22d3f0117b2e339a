#include "resultfiles/summary/result_units.h"

#include <gtest/gtest.h>

#include "base/units.h"

namespace overbend {
namespace {

/// Every place with a unit has a description, and no other has one.
void expect_both(const Json& units, const Json& descriptions, const std::string& path, int& places) {
  if (units.is_object()) {
    ASSERT_TRUE(descriptions.is_object()) << path;
    for (const auto& [key, below] : units.items()) {
      ASSERT_TRUE(descriptions.contains(key)) << path << "." << key;
      expect_both(below, descriptions.at(key), path + "." + key, places);
    }
  } else if (units.is_array()) {
    ASSERT_EQ(descriptions.size(), units.size()) << path;
    for (std::size_t i = 0; i < units.size(); ++i) expect_both(units[i], descriptions[i], path + "[]", places);
  } else if (units.is_string()) {
    ++places;
  }
}

void expect_known(const Json& units) {
  if (units.is_structured()) {
    for (const Json& below : units) expect_known(below);
  } else if (units.is_string() && units != "" && units != "-" && units != "see column units") {
    const std::string unit = units.get<std::string>();
    EXPECT_TRUE(unit_factor(unit, unit).has_value()) << unit;
  }
}

TEST(result_units, are_units_that_a_model_file_may_hold) {
  expect_known(stored_summary_units());
  expect_known(summary_units());
}

TEST(result_units, stand_where_descriptions_do) {
  int places = 0;
  expect_both(stored_summary_units(), summary_descriptions(), "", places);
  EXPECT_GT(places, 300);
}

TEST(result_units, are_those_of_the_file_of_results) {
  const Json& statics = stored_summary_units().at("static");
  EXPECT_EQ(statics.at("sagbend").at("max_bending_stress"), "Pa");
  EXPECT_EQ(statics.at("supports").at(0).at("reaction"), "N");
  EXPECT_EQ(summary_units().at("static").at("sagbend").at("max_bending_stress"), "N/m^2");
  EXPECT_EQ(summary_descriptions().at("static").at("lay_back"), "Horizontal distance from stern shoe to touchdown");
}

TEST(result_units, of_the_largest_over_time_say_so) {
  EXPECT_EQ(stored_summary_units().at("dynamic").at("top_tension").at("max"), "N");
  EXPECT_NE(summary_descriptions().at("dynamic").at("top_tension").at("max").get<std::string>(), "");
}

}  // namespace
}  // namespace overbend
