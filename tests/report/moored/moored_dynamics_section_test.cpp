#include "report/moored/moored_dynamics_section.h"

#include <gtest/gtest.h>

#include "report/dynamic/mooring_histories.h"
#include "report/page_text.h"
#include "report/static/mooring_data.h"
#include "report/synthetic_moorings.h"

namespace overbend {
namespace {

using testing::count;

DynamicResults moored() {
  DynamicResults results;
  testing::add_moored_dynamics(results);
  return results;
}

TEST(moored_dynamics_section, shows_slow_and_wave_parts_and_the_most_probable_largest_of_vessel_and_lines) {
  int figure = 0;
  const std::string section = moored_dynamics_section(moored(), figure);
  EXPECT_NE(section.find("<td class=\"t\">Sway, to port</td><td class=\"t\">m</td><td>-2.160</td><td>4.840</td>"
                         "<td>1.200</td><td>1.140</td><td>-1.110</td><td>3.730</td><td>1.100</td><td>0.990</td>"
                         "<td>0.300</td><td>-3.000</td><td>5.540</td>"),
            std::string::npos)
      << section;
  EXPECT_NE(section.find("<td class=\"t\">port bow</td><td class=\"t\">kN</td><td>281.8</td><td>416.8</td>"),
            std::string::npos);
  EXPECT_NE(section.find("46 slow cycles of sway"), std::string::npos);
  EXPECT_EQ(figure, 3);
}

TEST(moored_dynamics_section, shows_what_dynamic_positioning_gave_and_marks_a_limit_that_was_reached) {
  int figure = 0;
  DynamicResults results = moored();
  EXPECT_EQ(moored_dynamics_section(results, figure).find("Dynamic positioning"), std::string::npos);
  results.thrust = {{"surge", {-120e3, 800e3, 310e3, 95e3}, 941e3, 800e3, 12.3},
                    {"sway", {-10e3, 20e3, 5e3, 4e3}, 20e3, std::nullopt, 0.0},
                    {"yaw", {-3e6, 4e6, 1e6, 2e6}, 4e6, 9e6, 0.0}};
  const std::string told = moored_dynamics_section(results, figure);
  EXPECT_NE(told.find("<tr class=\"over\"><td class=\"t\">Thrust ahead</td><td>310.0</td><td>95.0</td><td>-120.0</td>"
                      "<td>800.0</td><td>941.0</td><td>800.0</td><td>12.3</td><td class=\"t\">kN</td>"),
            std::string::npos)
      << told;
  EXPECT_NE(told.find("<td>20.0</td><td>20.0</td><td>none</td><td>0.0</td>"), std::string::npos);
  EXPECT_NE(told.find("<td>9000</td><td>0.0</td><td class=\"t\">kN m</td>"), std::string::npos);
}

TEST(moored_dynamics_section, lists_events_and_what_a_brake_let_out_only_where_there_were_any) {
  int figure = 0;
  DynamicResults results = moored();
  const std::string told = moored_dynamics_section(results, figure);
  EXPECT_NE(told.find("<td>1234.5</td><td class=\"t\">starboard forward breast</td><td class=\"t\">brake renders</td>"),
            std::string::npos);
  EXPECT_NE(told.find("Brake let out"), std::string::npos);
  results.moorings[6].events.clear();
  results.moorings[6].brake_rendered = 0.0;
  const std::string calm = moored_dynamics_section(results, figure);
  EXPECT_EQ(calm.find("Events of the mooring lines"), std::string::npos);
  EXPECT_EQ(calm.find("Brake let out"), std::string::npos);
}

TEST(moored_dynamics_section, is_empty_of_a_run_with_a_told_motion) {
  int figure = 0;
  EXPECT_EQ(moored_dynamics_section(DynamicResults{}, figure), "");
  EXPECT_EQ(figure, 0);
}

TEST(mooring_histories, hold_the_slow_part_beside_the_whole_motion_and_every_line) {
  const Json all = mooring_history_data(moored());
  ASSERT_EQ(all.size(), 11u);
  EXPECT_EQ(all[1]["title"], "Sway from as drawn");
  EXPECT_EQ(all[1]["slow"]["low"].size(), all[1]["low"].size());
  EXPECT_EQ(all[2]["unit"], "deg");
  EXPECT_EQ(all[3]["group"], "moorings");
  EXPECT_EQ(all[3]["static"], 346.6);
  EXPECT_FALSE(all[3].contains("slow"));
}

TEST(mooring_data, places_midship_and_lines_where_the_results_have_them) {
  MooringScene scene;
  scene.length = 120.0;
  const Json data = mooring_figure_data(testing::synthetic_stages(), scene);
  ASSERT_EQ(data["states"].size(), 4u);
  EXPECT_EQ(data["states"][2]["sway"], 2.593);
  const Json& line = data["states"][0]["lines"][0];
  EXPECT_EQ(line["fairlead"], Json({57, 15, 3}));
  EXPECT_EQ(line["shape"].size(), 42u);
  EXPECT_TRUE(data["states"][3]["lines"][6]["parted"].get<bool>());
  EXPECT_TRUE(data["touchdown"].is_null());
}

}  // namespace
}  // namespace overbend
