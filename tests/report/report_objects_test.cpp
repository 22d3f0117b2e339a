#include <gtest/gtest.h>

#include <algorithm>

#include "report/page_text.h"
#include "report/report.h"
#include "report/synthetic_moorings.h"

namespace overbend {
namespace {

using testing::example_text;
using testing::section_text;
using testing::shown_text;
using testing::synthetic_hull_alone;
using testing::synthetic_lines;
using testing::synthetic_lines_in_time;

std::ptrdiff_t sections(const Document& document, const std::string& id) {
  return std::ranges::count(testing::section_ids(document), id);
}

TEST(report_objects, of_moorings_begins_with_a_verdict_and_has_what_applies) {
  StaticResults results = synthetic_hull_alone(testing::synthetic_stages());
  results.hull = testing::synthetic_hull();
  CheckRow lines;
  lines.id = "mooring_load";
  lines.name = "Mooring line, breaking load over safety factor";
  lines.status = CheckStatus::passed;
  lines.utilisation = 0.4;
  results.checks.rows = {lines};
  const Document document = report_document(results, example_text("moored-barge"));
  const std::string text = shown_text(document);
  EXPECT_EQ(document.front["verdict"]["words"], "PASSED");
  for (const char* id : {"moorings", "operation", "hull", "inputs", "assumptions", "model"}) {
    EXPECT_EQ(sections(document, id), 1) << id;
  }
  EXPECT_EQ(text.find("Tensioner"), std::string::npos);
}

TEST(report_objects, of_moorings_in_time_begins_with_the_run_and_has_no_pipe) {
  const Document document = testing::moored_document_in_time();
  const std::string text = shown_text(document);
  EXPECT_NE(text.find("Dynamic mooring analysis"), std::string::npos);
  EXPECT_NE(text.find("Maxima of a single run of"), std::string::npos);
  const std::vector<std::string> ids = testing::section_ids(document);
  auto last = ids.begin();
  for (const char* id : {"dynamic-figures", "statistics", "dynamic-moorings", "moorings", "hull", "inputs",
                         "assumptions", "run", "model"}) {
    EXPECT_EQ(sections(document, id), 1) << id;
    const auto place = std::ranges::find(ids, id);
    EXPECT_GE(place, last) << id;
    last = place;
  }
  EXPECT_NE(text.find("Across the hull, to port"), std::string::npos);
  EXPECT_NE(text.find("work done on hull and lines"), std::string::npos);
  for (const char* pipe : {"Tensioner", "Sagbend", "the route", "stern shoe", "the pipe"}) {
    EXPECT_EQ(text.substr(0, text.find("# Inputs\n")).find(pipe), std::string::npos) << pipe;
  }
  EXPECT_NE(json_text(document.data).find("\"title\":\"starboard forward breast\",\"unit\":\"kN\",\"frequency\""),
            std::string::npos);
}

TEST(report_objects, lists_the_inputs_of_hull_and_moorings) {
  const std::string text =
      shown_text(report_document(synthetic_hull_alone(testing::synthetic_moorings()), example_text("moored-barge")));
  EXPECT_NE(text.find("Mass | 19121.6"), std::string::npos) << text;
  EXPECT_NE(text.find("Types of line"), std::string::npos);
  EXPECT_NE(text.find("bearing 335.0 deg, 1000 m"), std::string::npos);
}

TEST(report_objects, of_lines_shows_each_end_and_over_time_only_after_a_run) {
  const std::string rest = shown_text(report_document(synthetic_lines(), example_text("jumper")));
  EXPECT_NE(rest.find("Static analysis of lines"), std::string::npos);
  EXPECT_NE(rest.find("\nNOT JUDGED\n"), std::string::npos);
  EXPECT_EQ(rest.find("Tension over time"), std::string::npos);
  const Document run = report_document(synthetic_lines(), synthetic_lines_in_time(), example_text("jumper"));
  const std::string moved = shown_text(run);
  EXPECT_NE(moved.find("Tension over time"), std::string::npos);
  EXPECT_NE(moved.find("54 s after a build-up of 27 s"), std::string::npos);
  EXPECT_NE(moved.find("jumper | first | 33.00"), std::string::npos);
  EXPECT_NE(section_text(run, "statistics").find("Tension at the first end, jumper"), std::string::npos);
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
  const Document document = report_document(results, example_text("jumper"));
  for (const char* id : {"criteria", "checks", "lines", "inputs", "calculation-sheet", "model"}) {
    EXPECT_EQ(sections(document, id), 1) << id;
  }
  for (const char* id : {"results", "figures", "summary", "balance", "moorings"}) {
    EXPECT_EQ(sections(document, id), 0) << id;
  }
  EXPECT_EQ(shown_text(document).find("Along pipe"), std::string::npos);
}

TEST(report_objects, a_goal_seek_on_a_hull_is_reported_as_that_on_a_lay) {
  SeekResults seek;
  seek.unknowns.emplace_back();
  seek.goals.emplace_back();
  const StaticResults hull = synthetic_hull_alone(testing::synthetic_moorings());
  EXPECT_EQ(sections(report_document(hull, example_text("moored-barge"), {.seek = &seek}), "seek"), 1);
}

TEST(report_objects, a_run_of_lines_says_in_which_sea_and_how_long_but_nothing_of_a_vessel) {
  const Document run = report_document(synthetic_lines(), synthetic_lines_in_time(), example_text("jumper"));
  const std::string inputs = section_text(run, "inputs");
  EXPECT_NE(inputs.find("Build-up, duration"), std::string::npos);
  for (const char* absent : {"Draught", "Tensioner", "Vessel motion", "Added mass, normal and axial"}) {
    EXPECT_EQ(inputs.find(absent), std::string::npos) << absent;
  }
}

TEST(report_objects, shows_results_even_where_the_model_can_no_longer_be_read) {
  const Document document = report_document(synthetic_hull_alone(testing::synthetic_moorings()), "no: [model");
  EXPECT_EQ(sections(document, "inputs"), 0);
  EXPECT_EQ(sections(document, "moorings"), 1);
}

}  // namespace
}  // namespace overbend
