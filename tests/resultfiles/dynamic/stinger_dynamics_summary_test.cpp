// A stinger on hinges over time, in summary.json.
#include <gtest/gtest.h>

#include "base/json.h"
#include "resultfiles/dynamic/dynamic_writer.h"
#include "support/dynamic_case.h"
#include "support/solved_case.h"

namespace overbend {
namespace {

TEST(stinger_dynamics_summary, has_the_first_section_itself_and_all_in_a_list) {
  const StaticResults& statics = testing::solved_case("BGL1-T250").results;
  const DynamicResults results = testing::filled_dynamics(statics);
  const Json stinger = read_json(dynamic_summary(statics, results))["dynamic"]["stinger"];
  const StingerSectionDynamics& first = results.stinger.front();
  EXPECT_EQ(stinger["name"], first.name);
  EXPECT_DOUBLE_EQ(stinger["angle"]["max"].get<double>(), first.angle.max);
  EXPECT_DOUBLE_EQ(stinger["hinge_force"]["vertical"]["min"].get<double>(), first.hinge_vertical.min);
  EXPECT_DOUBLE_EQ(stinger["draught"]["mean"].get<double>(), first.draught.mean);
  EXPECT_EQ(stinger["stop_hits"].get<std::int64_t>(), first.stop_hits);
  ASSERT_EQ(stinger["sections"].size(), 2U);
  EXPECT_DOUBLE_EQ(stinger["sections"][1]["stop_moment"]["std"].get<double>(), results.stinger[1].stop_moment.std);
}

TEST(stinger_dynamics_summary, is_left_out_where_the_stinger_stands_still) {
  const StaticResults& statics = testing::solved_case("BGL1-T250").results;
  DynamicResults results = testing::filled_dynamics(statics);
  results.stinger.clear();
  EXPECT_FALSE(read_json(dynamic_summary(statics, results))["dynamic"].contains("stinger"));
}

}  // namespace
}  // namespace overbend
