#include <gtest/gtest.h>

#include "report/page_text.h"
#include "report/report.h"
#include "report/synthetic_moorings.h"

namespace overbend {
namespace {

using testing::count;
using testing::example_text;
using testing::synthetic_hull_alone;
using testing::synthetic_lines;
using testing::synthetic_lines_in_time;
using testing::visible;

TEST(report_objects, of_moorings_begins_with_a_verdict_and_has_what_applies) {
  StaticResults results = synthetic_hull_alone(testing::synthetic_stages());
  results.hull = testing::synthetic_hull();
  CheckRow lines;
  lines.id = "mooring_load";
  lines.name = "Mooring line, breaking load over safety factor";
  lines.status = CheckStatus::passed;
  lines.utilisation = 0.4;
  results.checks.rows = {lines};
  const std::string page = report_html(results, example_text("moored-barge"));
  const std::string text = visible(page);
  EXPECT_NE(text.find("<div class=\"words\">PASSED</div>"), std::string::npos);
  for (const char* id : {"moorings", "operation", "hull", "inputs", "assumptions", "model"}) {
    EXPECT_EQ(count(text, "<section id=\"" + std::string(id) + "\">"), 1u) << id;
  }
  EXPECT_EQ(text.find("Tensioner"), std::string::npos);
  EXPECT_EQ(page.find("Report.side_view"), std::string::npos);
}

TEST(report_objects, of_moorings_in_time_begins_with_the_run_and_has_no_pipe) {
  const std::string page = testing::moored_page_in_time();
  const std::string text = visible(page);
  EXPECT_NE(text.find("Dynamic mooring analysis"), std::string::npos);
  EXPECT_NE(text.find("Maxima of a single run of"), std::string::npos);
  std::size_t last = 0;
  for (const char* id : {"dynamic-figures", "statistics", "dynamic-moorings", "moorings", "hull", "inputs",
                         "assumptions", "run", "model"}) {
    EXPECT_EQ(count(text, "<section id=\"" + std::string(id) + "\">"), 1u) << id;
    const std::size_t at = text.find("<section id=\"" + std::string(id) + "\">");
    EXPECT_GT(at, last) << id;
    last = at;
  }
  EXPECT_NE(text.find("Across the hull, to port"), std::string::npos);
  EXPECT_NE(text.find("work done on hull and lines"), std::string::npos);
  for (const char* pipe : {"Tensioner", "Sagbend", "the route", "stern shoe", "the pipe"}) {
    EXPECT_EQ(text.substr(0, text.find("<section id=\"inputs\">")).find(pipe), std::string::npos) << pipe;
  }
  EXPECT_EQ(page.find("Report.side_view"), std::string::npos);
  EXPECT_NE(page.find("\"title\":\"starboard forward breast\",\"unit\":\"kN\",\"frequency\""), std::string::npos);
}

TEST(report_objects, numbers_its_figures_in_the_order_of_the_page) {
  for (const std::string& page :
       {report_html(synthetic_hull_alone(testing::synthetic_stages()), example_text("moored-barge")),
        testing::moored_page_in_time(),
        report_html(synthetic_lines(), synthetic_lines_in_time(), example_text("jumper"))}) {
    std::size_t at = 0;
    int number = 0;
    while ((at = page.find("<figcaption>Figure ", at)) != std::string::npos) {
      at += std::string("<figcaption>Figure ").size();
      EXPECT_EQ(std::stoi(page.substr(at)), ++number);
    }
    EXPECT_GE(number, 3);
  }
}

TEST(report_objects, lists_the_inputs_of_hull_and_moorings) {
  const std::string text =
      visible(report_html(synthetic_hull_alone(testing::synthetic_moorings()), example_text("moored-barge")));
  EXPECT_NE(text.find("<td class=\"t\">Mass</td><td>19121.6</td>"), std::string::npos) << text;
  EXPECT_NE(text.find("Types of line"), std::string::npos);
  EXPECT_NE(text.find("bearing 335.0 deg, 1000 m"), std::string::npos);
}

TEST(report_objects, of_lines_shows_each_end_and_over_time_only_after_a_run) {
  const std::string rest = visible(report_html(synthetic_lines(), example_text("jumper")));
  EXPECT_NE(rest.find("Static analysis of lines"), std::string::npos);
  EXPECT_NE(rest.find("<div class=\"words\">NOT JUDGED</div>"), std::string::npos);
  EXPECT_EQ(rest.find("Tension over time"), std::string::npos);
  const std::string moved = visible(report_html(synthetic_lines(), synthetic_lines_in_time(), example_text("jumper")));
  EXPECT_NE(moved.find("Tension over time"), std::string::npos);
  EXPECT_NE(moved.find("54 s after a build-up of 27 s"), std::string::npos);
  EXPECT_NE(moved.find("<td class=\"t\">jumper</td><td class=\"t\">first</td><td>33.00</td>"), std::string::npos);
  const std::size_t statistics = moved.find("<section id=\"statistics\">");
  EXPECT_NE(moved.find("Tension at the first end, jumper", statistics), std::string::npos);
}

TEST(report_objects, judged_lines_have_their_checks_and_calculation_sheet_and_nothing_along_a_pipe) {
  StaticResults results = synthetic_lines();
  CheckRow row;
  row.id = "line_load";
  row.name = "Line, breaking load over safety factor";
  row.status = CheckStatus::passed;
  row.utilisation = 0.4;
  row.sheet = {{"U", "utilisation", "demand/capacity", 0.4, "1", "safety factor", Confirmation::not_needed, ""}};
  results.checks.rows = {row};
  const std::string text = visible(report_html(results, example_text("jumper")));
  for (const char* id : {"criteria", "checks", "lines", "inputs", "calculation-sheet", "check-inputs", "model"}) {
    EXPECT_EQ(count(text, "<section id=\"" + std::string(id) + "\">"), 1u) << id;
  }
  for (const char* id : {"results", "figures", "summary", "balance", "moorings"}) {
    EXPECT_EQ(count(text, "<section id=\"" + std::string(id) + "\">"), 0u) << id;
  }
  EXPECT_EQ(text.find("Along pipe"), std::string::npos);
}

TEST(report_objects, a_goal_seek_on_a_hull_is_told_as_that_on_a_lay) {
  SeekResults seek;
  seek.unknowns.emplace_back();
  seek.goals.emplace_back();
  const StaticResults hull = synthetic_hull_alone(testing::synthetic_moorings());
  const std::string text = visible(report_html(hull, example_text("moored-barge"), {.seek = &seek}));
  EXPECT_EQ(count(text, "<section id=\"seek\">"), 1u);
}

TEST(report_objects, a_run_of_lines_says_in_which_sea_and_how_long_but_nothing_of_a_vessel) {
  const std::string text = visible(report_html(synthetic_lines(), synthetic_lines_in_time(), example_text("jumper")));
  const std::string inputs = text.substr(text.find("<section id=\"inputs\">"));
  EXPECT_NE(inputs.find("Build-up, duration"), std::string::npos);
  for (const char* absent : {"Draught", "Tensioner", "Vessel motion", "Added mass, normal and axial"}) {
    EXPECT_EQ(inputs.substr(0, inputs.find("</section>")).find(absent), std::string::npos) << absent;
  }
}

TEST(report_objects, shows_results_even_where_the_model_can_no_longer_be_read) {
  const std::string text = visible(report_html(synthetic_hull_alone(testing::synthetic_moorings()), "no: [model"));
  EXPECT_EQ(text.find("<section id=\"inputs\">"), std::string::npos);
  EXPECT_NE(text.find("<section id=\"moorings\">"), std::string::npos);
}

}  // namespace
}  // namespace overbend
