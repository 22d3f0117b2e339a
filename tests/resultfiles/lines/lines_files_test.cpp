#include "resultfiles/lines/lines_files.h"

#include <gtest/gtest.h>

#include <limits>

#include "report/synthetic_moorings.h"
#include "resultfiles/static/results_reader.h"
#include "resultfiles/static/results_writer.h"
#include "support/solved_case.h"

namespace overbend {
namespace {

Description described() {
  Description description;
  description.source_text = "overbend: 1";
  description.source_file = "jumper.yaml";
  return description;
}

TEST(lines_files, at_rest_come_back_bit_for_bit) {
  const testing::TemporaryFolder folder;
  StaticResults results = testing::synthetic_lines();
  results.assumptions = {
      {AssumptionRank::governing, "one"}, {AssumptionRank::setting, "two"}, {AssumptionRank::other, "three"}};
  results.lines[0].utilisation = 0.1;
  results.lines[0].first.force = {1.0, -2.0, 1.0 / 3.0};
  write_static_files(results, described(), folder.path());
  const StoredStatics stored = read_static_results(folder.path() / "results.h5");
  EXPECT_EQ(stored.model_text, "overbend: 1");
  EXPECT_EQ(stored.model_file, "jumper.yaml");
  EXPECT_FALSE(stored.results.has_pipe());
  EXPECT_EQ(stored.results.title, results.title);
  EXPECT_EQ(stored.results.assumptions, results.assumptions);
  ASSERT_EQ(stored.results.lines.size(), 1u);
  const LineResult &was = results.lines[0], &is = stored.results.lines[0];
  EXPECT_EQ(is.name, was.name);
  EXPECT_EQ(is.utilisation, was.utilisation);
  EXPECT_EQ(is.first.force, was.first.force);
  ASSERT_EQ(is.nodes.size(), was.nodes.size());
  EXPECT_EQ(is.nodes[7].place, was.nodes[7].place);
  EXPECT_EQ(is.nodes[7].tension, was.nodes[7].tension);
}

TEST(lines_files, over_time_come_back_bit_for_bit) {
  const testing::TemporaryFolder folder;
  const std::vector<LineDynamics> lines = testing::synthetic_lines_in_time().lines;
  {
    Hdf5Writer file(folder.path() / "results.h5");
    file.group("/dynamic", "A run");
    write_lines_in_time(file, lines);
    file.close();
  }
  const std::vector<LineDynamics> read = read_lines_in_time(Hdf5Reader(folder.path() / "results.h5"));
  ASSERT_EQ(read.size(), 1u);
  EXPECT_EQ(read[0].name, "jumper");
  EXPECT_EQ(read[0].second_tension.std, lines[0].second_tension.std);
  EXPECT_EQ(read[0].max_tension, lines[0].max_tension);
  EXPECT_EQ(read[0].max_tension_at_nodes, lines[0].max_tension_at_nodes);
  EXPECT_FALSE(read[0].utilisation);
}

TEST(lines_files, the_table_has_a_row_per_node_and_what_a_run_added) {
  const std::vector<LineResult> lines = testing::synthetic_lines().lines;
  const std::string rest = lines_table(lines), moved = lines_table(lines, testing::synthetic_lines_in_time().lines);
  EXPECT_EQ(rest.find("line,s [m],x [m],y [m],z [m],tension [kN],least tension [kN],largest tension [kN]"), 0u);
  EXPECT_NE(rest.find("33,33,33"), std::string::npos);  // at rest all three are the same
  EXPECT_NE(moved.find("33,26.4,42.9"), std::string::npos);
}

TEST(lines_files, reject_what_is_no_number) {
  StaticResults results = testing::synthetic_lines();
  results.lines[0].second.tension = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(write_static_files(results, described(), "/nowhere"), std::runtime_error);
}

}  // namespace
}  // namespace overbend
