// Fatigue of welds in the report.
#include "report/dynamic/fatigue_section.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "report/bgl1_results.h"
#include "report/page_text.h"
#include "report/synthetic_dynamics.h"

namespace overbend {
namespace {

using testing::bgl1;
using testing::shown_text;

/// Two spots whose damage rate grows towards the tensioner, the inner one twice as large.
DynamicResults with_fatigue() {
  DynamicResults results = testing::synthetic_dynamics(bgl1().results);
  FatigueResults& fatigue = results.fatigue.emplace();
  fatigue.budget = 0.1;
  fatigue.design_factor = 3.0;
  fatigue.lay_rate = 12.0 / 360.0;
  for (const double times : {1.0, 2.0}) {
    FatigueSpot& spot = fatigue.spots.emplace_back();
    spot.name = times > 1.0 ? "root" : "cap";
    spot.curve = times > 1.0 ? "F1" : "D";
    for (const double s : results.station_s) spot.rate.push_back(times * 1e-9 * s);
    spot.cycles.assign(spot.rate.size(), 0.125);
    spot.range.assign(spot.rate.size(), 41.5e6);
    spot.worst_rate = spot.rate.back();
    spot.worst_s = results.station_s.back();
    spot.path_damage = times * 0.02;
    spot.standby = 36000.0 / times;
  }
  return results;
}

TEST(fatigue_section, shows_damage_standby_and_place) {
  const Blocks section = fatigue_section(bgl1().results, with_fatigue());
  const std::string text = shown_text(section);
  EXPECT_NE(text.find("\ncap | D |"), std::string::npos) << text;
  EXPECT_NE(text.find("| 41.5 | 450 | 0.02 | 10.0\n"), std::string::npos) << text;
  EXPECT_NE(text.find("| 41.5 | 450 | 0.04 | 5.0\n"), std::string::npos) << text;
  EXPECT_NE(text.find("120.0 m/h"), std::string::npos);
  EXPECT_NE(text.find("\nover: root | F1 |"), std::string::npos);  // 3 x 0.04 is more than the budget
  EXPECT_EQ(section.json()[0]["body"].back()["parts"], Json({"whole", "overbend"}));
}

TEST(fatigue_section, is_not_there_without_fatigue) {
  const DynamicResults plain = testing::synthetic_dynamics(bgl1().results);
  EXPECT_TRUE(fatigue_section(bgl1().results, plain).empty());
  EXPECT_TRUE(fatigue_figure_data(bgl1().results, plain).is_null());
}

TEST(fatigue_section, draws_damage_per_hour_from_the_tensioner_on) {
  const DynamicResults results = with_fatigue();
  const Json data = fatigue_figure_data(bgl1().results, results);
  ASSERT_EQ(data["spots"].size(), 2U);
  EXPECT_NEAR(data["s"].front().get<double>(), 0.0, 1e-6);
  EXPECT_EQ(data["s"].size(), data["spots"][0]["rate"].size());
  EXPECT_NEAR(data["spots"][1]["rate"].front().get<double>(), 3600.0 * 2e-9 * results.station_s.back(), 1e-9);
}

}  // namespace
}  // namespace overbend
