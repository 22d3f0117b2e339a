#include "app/print_fatigue.h"

#include <gtest/gtest.h>

namespace overbend {
namespace {

DynamicResults waiting(double standby) {
  DynamicResults results;
  results.station_s = {0.0, 500.0};
  FatigueSpot& spot = results.fatigue.emplace().spots.emplace_back();
  spot.name = "cap";
  spot.path_damage = 0.0031;
  spot.worst_rate = 1e-6;
  spot.worst_s = 420.0;
  spot.standby = standby;
  return results;
}

TEST(fatigue_lines, report_standby_damage_and_where) {
  EXPECT_EQ(fatigue_lines(waiting(36000.0)),
            "  fatigue 'cap'                     10.0 h of standby, damage on the lay path 0.0031, 0.0036 per hour "
            "80.0 m from "
            "the tensioner\n");
}

TEST(fatigue_lines, say_times_in_units_that_fit) {
  EXPECT_NE(fatigue_lines(waiting(600.0)).find(" 10 min of"), std::string::npos);
  EXPECT_NE(fatigue_lines(waiting(30.0 * 86400.0)).find(" 30 days of"), std::string::npos);
  EXPECT_NE(fatigue_lines(waiting(3.15576e9)).find(" 100 years of"), std::string::npos);
}

TEST(fatigue_lines, are_none_without_fatigue) {
  EXPECT_EQ(fatigue_lines(DynamicResults{}), "");
}

}  // namespace
}  // namespace overbend
