#include "resultfiles/moored/move_table.h"

#include <gtest/gtest.h>

#include "base/json.h"
#include "resultfiles/summary/summary_json.h"

namespace overbend {
namespace {

MooringResults pulled_ahead() {
  MooringResults results;
  MooringLineResult line;
  line.name = "bow, port";
  results.rest.moorings = {line};
  results.operation = "pull_ahead";
  results.distance = 12.0;
  results.winches = {{"bow, port", 1007.0, 996.0, 3.4e5, 3.3e5}};
  MoveStep step;
  step.lengths = {1007.0};
  step.tensions = {3.4e5};
  step.pipe.emplace();
  step.pipe->top_tension = 250e3;
  step.pipe->max_reaction_support = "ramp 1";
  results.steps = {step, step};
  results.steps[1].advance = 0.5;
  results.steps[1].lengths = {1006.5};
  results.steps[1].pipe->stinger_tip_clearance = 0.25;
  return results;
}

Json make_results_summary(const MooringResults& moorings) {
  StaticResults results;
  results.moorings = moorings;
  return static_summary_json(results);
}

TEST(move_table, has_a_row_per_place_with_hull_lines_and_pipe) {
  const std::string table = move_table(pulled_ahead());
  EXPECT_EQ(table.find("advance [m],surge [m],sway [m],heave [m],roll [deg],pitch [deg],yaw [deg],"), 0U) << table;
  EXPECT_NE(table.find("\"bow, port first segment [m]\",\"bow, port tension [kN]\",top tension [kN]"),
            std::string::npos)
      << table;
  EXPECT_NE(table.find("\r\n0,0,0,0,0,0,0,1007,340,250,"), std::string::npos) << table;
  EXPECT_NE(table.find("\r\n0.5,0,0,0,0,0,0,1006.5,340,250,"), std::string::npos) << table;
  EXPECT_NE(table.find(",ramp 1,0,\r\n"), std::string::npos) << table;  // no clearance at the first place
  EXPECT_NE(table.find(",ramp 1,0,0.25\r\n"), std::string::npos) << table;
}

TEST(move_table, is_in_the_summary_too) {
  const Json operation = make_results_summary(pulled_ahead())["operation"]["pull_ahead"];
  ASSERT_EQ(operation["steps"].size(), 2U);
  EXPECT_EQ(operation["steps"][1]["advance"], 0.5);
  EXPECT_EQ(operation["steps"][1]["winch_lengths"]["bow, port"], 1006.5);
  EXPECT_EQ(operation["steps"][1]["fairlead_tensions"]["bow, port"], 3.4e5);
  EXPECT_EQ(operation["steps"][0]["pipe"]["top_tension"], 250e3);
  EXPECT_TRUE(operation["steps"][0]["pipe"]["stinger_tip_clearance"].is_null());
}

TEST(move_table, of_anchors_says_what_is_due_when) {
  MooringResults results;
  results.operation = "anchor_plan";
  results.anchors = {{29, "bow, port", "least length", Vec3(963.0, 438.0, -89.0), Vec3(1323.0, 438.0, -89.0), 1061.0}};
  const Json operation = make_results_summary(results)["operation"];
  EXPECT_EQ(operation["anchors"][0]["joint"], 29);
  EXPECT_EQ(operation["anchors"][0]["line"], "bow, port");
  EXPECT_EQ(operation["anchors"][0]["reason"], "least length");
  EXPECT_EQ(operation["anchors"][0]["to"]["x"], 1323.0);
}

}  // namespace
}  // namespace overbend
