#include "report/moored/moorings_section.h"

#include <gtest/gtest.h>

#include "report/page_text.h"
#include "report/synthetic_moorings.h"

namespace overbend {
namespace {

using testing::count;
using testing::synthetic_moorings;
using testing::synthetic_pull_ahead;
using testing::synthetic_stages;

TEST(moorings_section, has_a_row_for_every_line_with_its_tension_and_what_it_uses_of_its_strength) {
  int figure = 3;
  const std::string section = moorings_section(synthetic_moorings(), figure);
  const std::size_t table = section.find("Mooring lines at rest");
  const std::string rows = section.substr(table, section.find("</table>", table) - table);
  EXPECT_EQ(count(rows, "<tr"), 9u);  // the head and eight lines
  // 346.6 kN of 2,594 kN: 13.4 %; the anchor of the bow line lies 65 deg from north.
  EXPECT_NE(rows.find("<td class=\"t\">port bow</td><td>65.0</td><td>1006.40</td>"), std::string::npos) << rows;
  EXPECT_NE(rows.find("<td>346.6</td>"), std::string::npos);
  EXPECT_NE(rows.find("<td>13.4</td>"), std::string::npos);
  EXPECT_NE(section.find("data-figure=\"mooring_plan\""), std::string::npos);
  EXPECT_NE(section.find("Figure 4. Plan of the moorings"), std::string::npos);
  EXPECT_EQ(figure, 5);
}

TEST(moorings_section, shows_natural_periods_and_stiffness_of_a_hull_that_floats) {
  int figure = 0;
  MooringResults results = synthetic_moorings();
  const std::string floating = moorings_section(results, figure);
  EXPECT_NE(floating.find("<td class=\"t\">sway</td><td>77.10</td>"), std::string::npos);
  EXPECT_NE(floating.find("Stiffness matrix"), std::string::npos);
  EXPECT_NE(floating.find("<td>184.8</td>"), std::string::npos);  // kN/m
  results.rest.vessel.natural_periods.clear();
  results.rest.vessel.stiffness.clear();
  const std::string held = moorings_section(results, figure);
  EXPECT_EQ(held.find("Natural periods"), std::string::npos);
  EXPECT_EQ(held.find("Stiffness matrix"), std::string::npos);
}

TEST(moorings_section, marks_a_line_beyond_its_breaking_load_and_says_what_is_wrong_with_the_others) {
  int figure = 0;
  MooringResults results = synthetic_moorings();
  results.rest.moorings[1].utilisation = 1.02;
  results.rest.moorings[2].slack = true;
  results.rest.moorings[3].anchor_uplift = 1e3;
  const std::string section = moorings_section(results, figure);
  EXPECT_NE(section.find("<tr class=\"over\"><td class=\"t\">port forward breast"), std::string::npos);
  EXPECT_NE(section.find(">slack</td>"), std::string::npos);
  EXPECT_NE(section.find(">lifts its anchor</td>"), std::string::npos);
}

TEST(moorings_section, tells_the_clearance_only_where_there_is_something_to_keep_clear_of) {
  int figure = 0;
  MooringResults results = synthetic_moorings();
  EXPECT_EQ(moorings_section(results, figure).find("Clearance"), std::string::npos);
  results.rest.moorings[0].clearance = 12.34;
  results.rest.moorings[0].nearest_object = "gas line";
  EXPECT_NE(moorings_section(results, figure).find("<td>12.3</td><td class=\"t\">gas line</td>"), std::string::npos);
}

TEST(operation_section, has_a_row_per_stage_and_names_the_parted_line) {
  int figure = 0;
  const std::string section = operation_section(synthetic_stages(), figure);
  EXPECT_EQ(count(section, "<tr"), 5u);  // the head, rest and three stages
  EXPECT_NE(section.find("<td class=\"t\">current to port</td><td>-0.012</td><td>2.593</td>"), std::string::npos);
  EXPECT_EQ(count(section, "<td>parted</td>"), 1u);
  EXPECT_EQ(operation_section(synthetic_moorings(), figure), "");
}

TEST(operation_section, of_a_pull_ahead_tells_what_every_winch_hauls_in_or_pays_out) {
  int figure = 0;
  const std::string section = operation_section(synthetic_pull_ahead(), figure);
  EXPECT_NE(section.find("<h2>Pull-ahead</h2>"), std::string::npos);
  // 12 m ahead along a line at 25 deg to the bow: -12 cos 25 deg.
  EXPECT_NE(section.find("<td class=\"t\">port bow</td><td>-10.876</td>"), std::string::npos) << section;
  EXPECT_NE(section.find("<td class=\"t\">port stern</td><td>+10.876</td>"), std::string::npos);
  EXPECT_NE(section.find("data-part=\"lengths\""), std::string::npos);
  EXPECT_EQ(section.find("data-part=\"stages\""), std::string::npos);
}

TEST(operation_section, of_a_pull_ahead_with_a_pipe_tells_what_the_pipe_has_place_by_place) {
  int figure = 0;
  MooringResults results = synthetic_pull_ahead();
  const std::string laid = operation_section(results, figure);
  EXPECT_NE(laid.find("<td>12.00</td><td>259.6</td><td>0.0</td><td>287.6</td><td>0.1400</td><td>145.2</td>"),
            std::string::npos);
  EXPECT_NE(laid.find("data-figure=\"move_pipe\""), std::string::npos);
  EXPECT_NE(laid.find("Lengths and tensions at 25 places"), std::string::npos);
  for (MoveStep& step : results.steps) step.pipe.reset();
  const std::string bare = operation_section(results, figure);
  EXPECT_EQ(bare.find("move_pipe"), std::string::npos);
  EXPECT_EQ(bare.find("The pipe at the places"), std::string::npos);
}

TEST(operation_section, lists_the_anchors_that_are_due_though_there_are_no_stages) {
  int figure = 0;
  MooringResults results = synthetic_moorings();
  results.operation = "anchor_plan";
  results.anchors = {{41, "port stern", "length", {-963.0, 438.0, -89.0}, {-450.0, 438.0, -89.0}, 505.2}};
  const std::string section = operation_section(results, figure);
  EXPECT_NE(section.find("<td>41</td><td class=\"t\">port stern</td><td class=\"t\">length</td><td>-963.0</td>"),
            std::string::npos);
  EXPECT_EQ(section.find("Offset of the vessel"), std::string::npos);
}

}  // namespace
}  // namespace overbend
