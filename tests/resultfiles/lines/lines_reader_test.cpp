#include "resultfiles/lines/lines_reader.h"

#include <gtest/gtest.h>

#include <filesystem>

#include "report/synthetic_moorings.h"
#include "resultfiles/lines/lines_writer.h"
#include "resultfiles/static/results_reader.h"

namespace overbend {
namespace {

class LinesReader : public ::testing::Test {
 protected:
  void SetUp() override { std::filesystem::create_directories(folder_); }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  StoredLines written_and_read(const LinesResults& results) const {
    Description description;
    description.source_text = "overbend: 1";
    description.source_file = "jumper.yaml";
    write_lines_files(results, description, folder_);
    return read_lines_results(folder_ / "results.h5");
  }

  std::filesystem::path folder_ =
      std::filesystem::temp_directory_path() /
      ("lines_reader_" + std::string(::testing::UnitTest::GetInstance()->current_test_info()->name()));
};

TEST_F(LinesReader, gives_back_a_run_bit_for_bit) {
  LinesResults results = testing::synthetic_lines(true);
  results.assumptions = {
      {AssumptionRank::governing, "one"}, {AssumptionRank::setting, "two"}, {AssumptionRank::other, "three"}};
  results.energy_drift = 1e-5 / 3.0;
  results.steps = 811;
  results.lines[0].utilisation = 0.1;
  results.lines[0].first.force = {1.0, -2.0, 1.0 / 3.0};
  const StoredLines stored = written_and_read(results);
  EXPECT_EQ(stored.model_text, "overbend: 1");
  EXPECT_EQ(stored.model_file, "jumper.yaml");
  EXPECT_EQ(stored.results.title, results.title);
  EXPECT_EQ(stored.results.assumptions, results.assumptions);
  EXPECT_TRUE(stored.results.moved);
  EXPECT_EQ(stored.results.time, results.time);
  EXPECT_EQ(stored.results.energy_drift, results.energy_drift);
  EXPECT_EQ(stored.results.steps, 811);
  ASSERT_EQ(stored.results.lines.size(), 1u);
  const LineResult& was = results.lines[0];
  const LineResult& is = stored.results.lines[0];
  EXPECT_EQ(is.name, was.name);
  EXPECT_EQ(is.utilisation, was.utilisation);
  EXPECT_EQ(is.first.force, was.first.force);
  EXPECT_EQ(is.second.in_time.std, was.second.in_time.std);
  EXPECT_EQ(is.largest_in_time, was.largest_in_time);
  EXPECT_EQ(is.second_history, was.second_history);
  ASSERT_EQ(is.nodes.size(), was.nodes.size());
  EXPECT_EQ(is.nodes[7].place, was.nodes[7].place);
  EXPECT_EQ(is.nodes[7].largest_tension, was.nodes[7].largest_tension);
}

TEST_F(LinesReader, of_lines_at_rest_has_no_histories_and_is_no_lay) {
  const StoredLines stored = written_and_read(testing::synthetic_lines(false));
  EXPECT_FALSE(stored.results.moved);
  EXPECT_TRUE(stored.results.time.empty());
  EXPECT_TRUE(has_lines(folder_ / "results.h5"));
  EXPECT_FALSE(has_moorings_alone(folder_ / "results.h5"));
}

}  // namespace
}  // namespace overbend
