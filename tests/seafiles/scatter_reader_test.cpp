#include "seafiles/scatter_reader.h"

#include <gtest/gtest.h>

#include <numbers>
#include <numeric>

namespace overbend {
namespace {

std::optional<ScatterDiagram> taken(const std::string& text) {
  Diagnostics diagnostics;
  std::optional<ScatterDiagram> diagram = read_scatter_text(text, "seas.csv", diagnostics);
  EXPECT_FALSE(diagnostics.has_errors()) << diagnostics.lines(Severity::error).front();
  return diagram;
}

std::string read_error(const std::string& text) {
  Diagnostics diagnostics;
  EXPECT_FALSE(read_scatter_text(text, "seas.csv", diagnostics));
  const std::vector<std::string> lines = diagnostics.lines(Severity::error);
  return lines.empty() ? "" : lines.front();
}

double total(const ScatterDiagram& diagram, std::size_t month) {
  return std::accumulate(diagram.seas.begin(), diagram.seas.end(), 0.0,
                         [&](double sum, const ScatterDiagram::Sea& sea) { return sum + sea.fraction[month]; });
}

void expect_part(const std::string& text, const std::string& part) {
  const std::string error = read_error(text);
  EXPECT_NE(error.find(part), std::string::npos) << error;
}

}  // namespace

TEST(scatter_reader, counts_become_fractions_of_the_time) {
  const auto diagram = taken("# a field\nhs_m,5,7,9\n0.25,10,20,\n0.75,5,10,5\n");
  ASSERT_TRUE(diagram);
  ASSERT_EQ(diagram->seas.size(), 6U);
  EXPECT_DOUBLE_EQ(diagram->seas[1].hs_width, 0.5);
  EXPECT_DOUBLE_EQ(diagram->seas[1].fraction.at(0), 0.4);
  EXPECT_DOUBLE_EQ(diagram->seas[1].hs, 0.25);
  EXPECT_DOUBLE_EQ(diagram->seas[1].tp, 7.0);
  EXPECT_FALSE(diagram->seas[1].from);
  EXPECT_DOUBLE_EQ(diagram->seas[2].fraction.at(0), 0.0);
  EXPECT_NEAR(total(*diagram, 0), 1.0, 1e-15);
}

TEST(scatter_reader, probabilities_stand_as_they_are) {
  const auto diagram = taken("# values: per cent\nhs_m,5,7\n0.25,40,30\n0.75,10,15\n");
  EXPECT_DOUBLE_EQ(diagram->seas[0].fraction[0], 0.4);
  EXPECT_NEAR(total(*diagram, 0), 0.95, 1e-15);
  expect_part("# values: probability\nhs_m,5,7\n0.25,0.9,0.3\n0.75,0,0\n", "add up to 1.2");
  expect_part("# values: hours\nhs_m,5,7\n0.25,1,1\n", "counts, probability or per cent");
}

TEST(scatter_reader, takes_ranges_and_passes_over_totals) {
  const auto diagram = taken("hs_m,4-6,6-8,total\n0-0.5,3,1,4\n0.5-1,2,2,4\nsum,5,3,8\n");
  ASSERT_EQ(diagram->seas.size(), 4U);
  EXPECT_DOUBLE_EQ(diagram->seas[3].hs, 0.75);
  EXPECT_DOUBLE_EQ(diagram->seas[3].tp, 7.0);
  EXPECT_DOUBLE_EQ(diagram->seas[3].hs_width, 0.5);
  EXPECT_DOUBLE_EQ(diagram->seas[3].fraction[0], 0.25);
}

TEST(scatter_reader, takes_months_and_directions) {
  std::string text = "month,from_deg,hs_m,6,8\n";
  for (int month = 1; month <= 12; ++month) {
    const std::string name = month == 2 ? "feb" : std::to_string(month);
    text += name + ",0,0.5," + std::to_string(month) + ",1\n" + name + ",90,1.5,1,1\n";
  }
  const auto diagram = taken(text);
  ASSERT_EQ(diagram->seas.size(), 4U);
  ASSERT_EQ(diagram->seas[0].fraction.size(), 12U);
  EXPECT_DOUBLE_EQ(diagram->seas[0].fraction[1], 2.0 / 5.0);
  EXPECT_DOUBLE_EQ(*diagram->seas[2].from, std::numbers::pi / 2.0);
  for (std::size_t month = 0; month < 12; ++month) EXPECT_NEAR(total(*diagram, month), 1.0, 1e-15);
}

TEST(scatter_reader, says_line_column_and_reason_of_an_error) {
  expect_part("", "an empty file");
  expect_part("height,5,7\n", "seas.csv:1: found 'height'");
  expect_part("hs_m\n0.5\n", "no peak periods");
  expect_part("hs_m,5,long\n", "column 3: found 'long'");
  expect_part("hs_m,5,7,10\n0.5,1,1,1\n", "not even");
  expect_part("hs_m,5,7\n0.5,1\n", "seas.csv:2: found 2 columns");
  expect_part("hs_m,5,7\n0.5,1,-1\n", "seas.csv:2: column 3: found '-1' under 7");
  expect_part("Hs (m),5,7\n0.5,1,1\n1,1,1\n", "whether the periods are Tp or Tz");
  expect_part("Tz (s) / Hs (m),5,7\n0.5,1,1\n", "seas.csv:1: found 'Tz (s) / Hs (m)'");
  expect_part("hs_m,2-4,5-7\n0.5,1,1\n1,1,1\n", "with 5-7 after 2-4");
  expect_part("hs_m,2-4,5\n0.5,1,1\n1,1,1\n", "some are ranges and some are not");
  expect_part("hs_m,5,7\n0.5,10%,20\n1,1%,1%\n", "with and without a per cent sign");
  expect_part("hs_m,5,7,total\n0.5,1,1,3\n1,1,1,2\n", "seas.csv:2: total: found '3' for values that add up to 2");
  expect_part("hs_m,5,7\n0.5,1,1\n1,1,1\ntotal,2,3\n", "seas.csv:4: total: found '3' for values that add up to 2");
  expect_part("hs_m,5,7\n0.5,1,1\n1.5,1,1\n2,1,1\n", "wave heights that are not even");
  expect_part("hs_m,5,7\n0.5,1,1\n0.5,1,1\n", "twice");
  expect_part("hs_m,5,7\n", "a header without rows");
  expect_part("hs_m,5,7\n0.5,0,0\n1,0,0\n", "no seas");
  expect_part("month,hs_m,5,7\n13,0.5,1,1\n", "1 to 12");
  expect_part("month,hs_m,5,7\n1,0.5,1,1\n1,1,1,1\n", "month 2: found no seas");
  expect_part("from_deg,hs_m,5,7\n400,0.5,1,1\n", "an azimuth");
}

}  // namespace overbend
