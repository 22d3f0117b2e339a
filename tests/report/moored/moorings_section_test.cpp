#include "report/moored/moorings_section.h"

#include <gtest/gtest.h>

#include "report/page_text.h"
#include "report/synthetic_moorings.h"

namespace overbend {
namespace {

using testing::count;
using testing::shown_text;
using testing::synthetic_moorings;
using testing::synthetic_pull_ahead;
using testing::synthetic_stages;

/// "mooring_plan field, mooring_profile rest"
std::string figure_parts(const Blocks& section) {
  std::string text;
  for (const Json& block : section.json()[0]["body"]) {
    if (block["kind"] != "figure") continue;
    for (const std::string part : block["parts"]) {
      text += (text.empty() ? "" : ", ") + block["id"].get<std::string>() + " " + part;
    }
  }
  return text;
}

TEST(moorings_section, has_a_row_for_every_line_with_its_tension_and_what_it_uses_of_its_strength) {
  const Blocks section = moorings_section(synthetic_moorings());
  const std::string text = shown_text(section);
  // 346.6 kN of 2,594 kN: 0.134; the anchor of the bow line lies 65 deg from north.
  EXPECT_NE(text.find("\nport bow | 1006.40 | 346.6 |"), std::string::npos) << text;
  EXPECT_NE(text.find(" | 65.0 | 0.134 |"), std::string::npos);
  for (const MooringLineResult& line : synthetic_moorings().rest.moorings) {
    EXPECT_EQ(count(text, "\n" + line.name + " |"), 1u) << line.name;
  }
  EXPECT_EQ(figure_parts(section), "mooring_plan field, mooring_profile rest");
}

TEST(moorings_section, shows_natural_periods_and_stiffness_of_a_hull_that_floats) {
  MooringResults results = synthetic_moorings();
  const std::string floating = shown_text(moorings_section(results));
  EXPECT_NE(floating.find("\nsway | 77.10\n"), std::string::npos);
  EXPECT_NE(floating.find("# Stiffness matrix"), std::string::npos);
  EXPECT_NE(floating.find(" | 184.8 |"), std::string::npos);  // kN/m
  results.rest.vessel.natural_periods.clear();
  results.rest.vessel.stiffness.clear();
  const std::string held = shown_text(moorings_section(results));
  EXPECT_EQ(held.find("Natural periods"), std::string::npos);
  EXPECT_EQ(held.find("Stiffness matrix"), std::string::npos);
}

TEST(moorings_section, marks_a_line_beyond_its_breaking_load_and_says_what_is_wrong_with_the_others) {
  MooringResults results = synthetic_moorings();
  results.rest.moorings[1].utilisation = 1.02;
  results.rest.moorings[2].slack = true;
  results.rest.moorings[3].anchor_uplift = 1e3;
  const std::string text = shown_text(moorings_section(results));
  EXPECT_NE(text.find("\nover: port forward breast"), std::string::npos);
  EXPECT_NE(text.find(" | slack\n"), std::string::npos);
  EXPECT_NE(text.find(" | lifts its anchor\n"), std::string::npos);
}

TEST(moorings_section, has_a_clearance_only_where_there_is_something_to_keep_clear_of) {
  MooringResults results = synthetic_moorings();
  EXPECT_EQ(shown_text(moorings_section(results)).find("Clearance"), std::string::npos);
  results.rest.moorings[0].clearance = 12.34;
  results.rest.moorings[0].nearest_object = "gas line";
  EXPECT_NE(shown_text(moorings_section(results)).find(" | 12.3 | gas line\n"), std::string::npos);
}

TEST(operation_section, has_a_row_per_stage_and_names_the_parted_line) {
  const Blocks section = operation_section(synthetic_stages());
  const std::string text = shown_text(section);
  EXPECT_EQ(section.json()[0]["body"].back()["rows"].size(), 4u);  // rest and three stages
  EXPECT_NE(text.find("\ncurrent to port | -0.012 | 2.593 |"), std::string::npos) << text;
  EXPECT_EQ(count(text, "| parted"), 1u);
  EXPECT_TRUE(operation_section(synthetic_moorings()).empty());
}

TEST(operation_section, of_a_pull_ahead_has_what_every_winch_hauls_in_or_pays_out) {
  const Blocks section = operation_section(synthetic_pull_ahead());
  const std::string text = shown_text(section);
  EXPECT_NE(text.find("# Pull-ahead\n"), std::string::npos);
  // 12 m ahead along a line at 25 deg to the bow: -12 cos 25 deg.
  EXPECT_NE(text.find("\nport bow | -10.876 |"), std::string::npos) << text;
  EXPECT_NE(text.find("\nport stern | +10.876 |"), std::string::npos);
  EXPECT_EQ(figure_parts(section), "mooring_stages tensions, mooring_stages lengths, move_pipe pipe");
}

TEST(operation_section, of_a_pull_ahead_with_a_pipe_has_what_the_pipe_bears_place_by_place) {
  MooringResults results = synthetic_pull_ahead();
  const std::string laid = shown_text(operation_section(results));
  EXPECT_NE(laid.find("\n12.00 | 259.6 | 0.0 | 287.6 | 0.1400 | 145.2 |"), std::string::npos) << laid;
  EXPECT_NE(laid.find("# Lengths and tensions at 25 positions"), std::string::npos);
  for (MoveStep& step : results.steps) step.pipe.reset();
  const Blocks bare = operation_section(results);
  EXPECT_EQ(figure_parts(bare).find("move_pipe"), std::string::npos);
  EXPECT_EQ(shown_text(bare).find("The pipe at the positions"), std::string::npos);
}

TEST(operation_section, lists_the_anchors_that_are_due_though_there_are_no_stages) {
  MooringResults results = synthetic_moorings();
  results.operation = "anchor_plan";
  results.anchors = {{41, "port stern", "length", {-963.0, 438.0, -89.0}, {-450.0, 438.0, -89.0}, 505.2}};
  const std::string text = shown_text(operation_section(results));
  EXPECT_NE(text.find("\n41 | port stern | length | -963.0 |"), std::string::npos);
  EXPECT_EQ(text.find("Offset of the vessel"), std::string::npos);
}

}  // namespace
}  // namespace overbend
