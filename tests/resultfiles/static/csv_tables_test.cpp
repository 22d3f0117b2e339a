#include <gtest/gtest.h>

#include "resultfiles/static/results_writer.h"
#include "support/csv_text.h"
#include "support/solved_case.h"

namespace overbend {
namespace {

using testing::csv_cells;
using testing::csv_lines;
using testing::solved_case;
using testing::value_in;

TEST(pipe_table, has_a_row_per_station_in_engineering_units) {
  const StaticResults& results = solved_case("BGL1-T250").results;
  const std::vector<std::string> lines = csv_lines(pipe_table(results));
  ASSERT_EQ(lines.size(), results.stations.size() + 1);
  for (const std::size_t i : {std::size_t{0}, results.stations.size() / 2, results.stations.size() - 1}) {
    const Station& station = results.stations[i];
    EXPECT_NEAR(value_in(lines, i + 1, "s [m]"), station.s, 1e-9 * station.s);
    EXPECT_NEAR(value_in(lines, i + 1, "z [m]"), station.p_W.z(), 1e-9 * std::abs(station.p_W.z()));
    EXPECT_NEAR(value_in(lines, i + 1, "tension [kN]"), station.effective_tension / 1e3, 1e-6);
    EXPECT_NEAR(value_in(lines, i + 1, "bending moment [kN m]"), station.bending_moment / 1e3, 1e-6);
    EXPECT_NEAR(value_in(lines, i + 1, "von Mises stress [MPa]"), station.von_mises / 1e6, 1e-8);
    EXPECT_NEAR(value_in(lines, i + 1, "strain [%]"), station.strain * 100, 1e-10);
    EXPECT_NEAR(value_in(lines, i + 1, "curvature [1/m]"), station.curvature, 1e-9 * station.curvature);
  }
}

TEST(pipe_table, has_the_columns_of_the_contract_first) {
  const std::string expected =
      "s [m],x [m],y [m],z [m],tension [kN],bending moment [kN m],curvature [1/m],axial stress [MPa],"
      "bending stress [MPa],hoop stress [MPa],von Mises stress [MPa],strain [%],";
  EXPECT_EQ(pipe_table(solved_case("BGL1-T250").results).substr(0, expected.size()), expected);
}

TEST(pipe_table, counts_the_length_from_the_tensioner_too) {
  const StaticResults& results = solved_case("BGL1-T250").results;
  const std::vector<std::string> lines = csv_lines(pipe_table(results));
  EXPECT_EQ(value_in(lines, results.stations.size(), "from tensioner [m]"), 0.0);
  EXPECT_NEAR(value_in(lines, 1, "from tensioner [m]"), results.total_length, 1e-9 * results.total_length);
  const std::vector<std::string> rows = csv_lines(supports_table(results));
  EXPECT_NEAR(value_in(rows, 1, "from tensioner [m]"), results.total_length - results.supports[0].rows[0].s, 1e-6);
}

TEST(every_table, has_as_many_cells_in_each_row_as_in_its_head) {
  const StaticResults& results = solved_case("BGL1-T250").results;
  for (const std::string& text : {pipe_table(results), supports_table(results)}) {
    const std::vector<std::string> lines = csv_lines(text);
    for (const std::string& line : lines) EXPECT_EQ(csv_cells(line).size(), csv_cells(lines[0]).size()) << line;
  }
}

TEST(supports_table, has_a_row_per_roller) {
  const StaticResults& results = solved_case("BGL1-T250").results;
  const std::vector<std::string> lines = csv_lines(supports_table(results));
  ASSERT_EQ(lines.size(), 14U);
  EXPECT_EQ(lines[1].substr(0, 15), "ramp1,1,bottom,");
  const RollerResult& roller = results.supports[0].rows.at(0).rollers.at(0);
  EXPECT_NEAR(value_in(lines, 1, "reaction normal [kN]"), roller.reaction / 1e3, 1e-9);
  EXPECT_NEAR(value_in(lines, 1, "reaction vertical [kN]"), roller.vertical / 1e3, 1e-9);
  EXPECT_NEAR(value_in(lines, 1, "reaction longitudinal [kN]"), roller.longitudinal / 1e3, 1e-9);
  EXPECT_NEAR(value_in(lines, 1, "separation [m]"), roller.separation, 1e-12);
}

TEST(supports_table, has_its_head_alone_in_j_lay) {
  EXPECT_EQ(csv_lines(supports_table(solved_case("J12-D400-T560").results)).size(), 1U);
}

TEST(supports_table, quotes_names_with_commas_and_quotes) {
  StaticResults results = solved_case("BGL1-T250").results;
  results.supports[0].name = "box 1, \"new\"";
  const std::string expected = "\"box 1, \"\"new\"\"\",1,bottom,";
  EXPECT_EQ(csv_lines(supports_table(results))[1].substr(0, expected.size()), expected);
}

}  // namespace
}  // namespace overbend
