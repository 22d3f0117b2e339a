#include "report/moored/moored_dynamics_section.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "report/dynamic/mooring_histories.h"
#include "report/page_text.h"
#include "report/static/mooring_data.h"
#include "report/synthetic_moorings.h"

namespace overbend {
namespace {

using testing::shown_text;

DynamicResults moored() {
  DynamicResults results;
  testing::add_moored_dynamics(results);
  return results;
}

TEST(moored_dynamics_section, shows_slow_and_wave_parts_and_the_most_probable_largest_of_vessel_and_lines) {
  const Blocks blocks = moored_dynamics_section(moored());
  const std::string section = shown_text(blocks);
  EXPECT_NE(
      section.find("\nSway, to port | m | -2.160 | 4.840 | 1.200 | 1.140 | -1.110 | 3.730 | 1.100 | 0.990 | 0.300 | "
                   "-3.000 | 5.540\n"),
      std::string::npos)
      << section;
  EXPECT_NE(section.find("\nport bow | kN | 281.8 | 416.8 |"), std::string::npos);
  EXPECT_NE(section.find("46 slow cycles of sway"), std::string::npos);
  EXPECT_EQ(std::ranges::count(blocks.json()[0]["body"], "figure", [](const Json& b) { return b["kind"]; }), 3);
}

TEST(moored_dynamics_section, shows_what_dynamic_positioning_supplied_and_marks_a_limit_that_was_reached) {
  DynamicResults results = moored();
  EXPECT_EQ(shown_text(moored_dynamics_section(results)).find("Dynamic positioning"), std::string::npos);
  results.thrust = {{"surge", {-120e3, 800e3, 310e3, 95e3}, 941e3, 800e3, 12.3},
                    {"sway", {-10e3, 20e3, 5e3, 4e3}, 20e3, std::nullopt, 0.0},
                    {"yaw", {-3e6, 4e6, 1e6, 2e6}, 4e6, 9e6, 0.0}};
  const std::string section = shown_text(moored_dynamics_section(results));
  EXPECT_NE(section.find("\nover: Thrust ahead | 310.0 | 95.0 | -120.0 | 800.0 | 941.0 | 800.0 | 12.3 | kN\n"),
            std::string::npos)
      << section;
  EXPECT_NE(section.find("20.0 | 20.0 | none | 0.0"), std::string::npos);
  EXPECT_NE(section.find("9000 | 0.0 | kN m\n"), std::string::npos);
}

TEST(moored_dynamics_section, lists_events_and_what_a_brake_let_out_only_where_there_were_any) {
  DynamicResults results = moored();
  const std::string section = shown_text(moored_dynamics_section(results));
  EXPECT_NE(section.find("\n1234.5 | starboard forward breast | brake renders\n"), std::string::npos);
  EXPECT_NE(section.find("Brake rendered"), std::string::npos);
  results.moorings[6].events.clear();
  results.moorings[6].brake_rendered = 0.0;
  const std::string calm = shown_text(moored_dynamics_section(results));
  EXPECT_EQ(calm.find("Events of the mooring lines"), std::string::npos);
  EXPECT_EQ(calm.find("Brake rendered"), std::string::npos);
}

TEST(moored_dynamics_section, is_empty_for_a_run_with_a_prescribed_motion) {
  EXPECT_TRUE(moored_dynamics_section(DynamicResults{}).empty());
}

TEST(mooring_histories, hold_the_slow_part_in_addition_to_the_whole_motion_and_every_line) {
  const Json all = mooring_history_data(moored());
  ASSERT_EQ(all.size(), 11u);
  EXPECT_EQ(all[1]["title"], "Sway from the nominal pose");
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
