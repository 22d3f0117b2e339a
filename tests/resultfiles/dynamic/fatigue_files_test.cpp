// Fatigue of welds through the files of a run.
#include "resultfiles/dynamic/fatigue_files.h"

#include <gtest/gtest.h>

#include "base/json.h"
#include "resultfiles/dynamic/dynamic_reader.h"
#include "resultfiles/dynamic/dynamic_writer.h"
#include "resultfiles/static/finite_check.h"
#include "results/fields/fatigue_fields.h"
#include "support/csv_text.h"
#include "support/dynamic_case.h"
#include "support/result_visitors.h"
#include "support/solved_case.h"

namespace overbend {
namespace {

DynamicResults with_fatigue(const StaticResults& statics) {
  DynamicResults results = testing::filled_dynamics(statics);
  testing::FillVisitor fill;
  FatigueResults& fatigue = results.fatigue.emplace();
  visit_fatigue(fatigue, fill);
  fatigue.spots.resize(2);
  for (FatigueSpot& spot : fatigue.spots) {
    visit_fatigue_spot(spot, fill);
    for (std::vector<double>* list : {&spot.rate, &spot.cycles, &spot.range}) list->resize(results.station_s.size());
    visit_fatigue_along(spot, fill);
  }
  return results;
}

std::string result_bits(const FatigueResults& fatigue) {
  testing::BitsVisitor bits;
  visit_fatigue(fatigue, bits);
  for (const FatigueSpot& spot : fatigue.spots) {
    visit_fatigue_spot(spot, bits);
    visit_fatigue_along(spot, bits);
  }
  return bits.text;
}

TEST(fatigue_files, field_lists_hold_every_member) {
  testing::SizeVisitor fatigue, spot;
  visit_fatigue<const FatigueResults>(FatigueResults{}, fatigue);
  visit_fatigue_spot<const FatigueSpot>(FatigueSpot{}, spot);
  visit_fatigue_along<const FatigueSpot>(FatigueSpot{}, spot);
  EXPECT_EQ(fatigue.bytes + testing::kListBytes, sizeof(FatigueResults));
  EXPECT_EQ(spot.bytes, sizeof(FatigueSpot));
}

TEST(fatigue_files, results_h5_gives_fatigue_back_bit_for_bit) {
  const testing::TemporaryFolder folder;
  const auto& [description, statics] = testing::solved_case("BGL1-T250");
  const DynamicResults results = with_fatigue(statics);
  const RunStore store = testing::filled_run(folder / "run", 100);
  write_dynamic_hdf5(statics, results, store, description, folder / "results.h5");
  const DynamicResults read = read_dynamic_results(folder / "results.h5").results;
  ASSERT_TRUE(read.fatigue);
  EXPECT_EQ(result_bits(*read.fatigue), result_bits(*results.fatigue));
}

TEST(fatigue_files, a_run_without_fatigue_has_none_in_its_files) {
  const testing::TemporaryFolder folder;
  const auto& [description, statics] = testing::solved_case("BGL1-T250");
  const DynamicResults results = testing::filled_dynamics(statics);
  const RunStore store = testing::filled_run(folder / "run", 100);
  write_dynamic_hdf5(statics, results, store, description, folder / "results.h5");
  EXPECT_FALSE(read_dynamic_results(folder / "results.h5").results.fatigue);
  EXPECT_FALSE(read_json(dynamic_summary(statics, results))["dynamic"].contains("fatigue"));
}

TEST(fatigue_files, the_summary_names_the_spots) {
  const StaticResults& statics = testing::solved_case("BGL1-T250").results;
  const DynamicResults results = with_fatigue(statics);
  const Json fatigue = read_json(dynamic_summary(statics, results))["dynamic"]["fatigue"];
  EXPECT_DOUBLE_EQ(fatigue["budget"].get<double>(), results.fatigue->budget);
  EXPECT_DOUBLE_EQ(fatigue["lay_rate"].get<double>(), results.fatigue->lay_rate);
  ASSERT_EQ(fatigue["spots"].size(), 2U);
  const FatigueSpot& spot = results.fatigue->spots[1];
  EXPECT_EQ(fatigue["spots"][1]["name"], spot.name);
  EXPECT_DOUBLE_EQ(fatigue["spots"][1]["standby"].get<double>(), spot.standby);
  EXPECT_DOUBLE_EQ(fatigue["spots"][1]["path_damage"].get<double>(), spot.path_damage);
  EXPECT_DOUBLE_EQ(fatigue["spots"][1]["worst_s"].get<double>(), spot.worst_s);
}

TEST(fatigue_files, the_table_has_a_row_for_every_station_and_ranges_in_mpa) {
  const StaticResults& statics = testing::solved_case("BGL1-T250").results;
  DynamicResults results = with_fatigue(statics);
  results.fatigue->spots[0].name = "cap";
  results.fatigue->spots[0].range[1] = 12.5e6;
  const std::string text = fatigue_table(results);
  EXPECT_NE(text.find("cap equivalent stress range [MPa]"), std::string::npos);
  EXPECT_NE(text.find("cap damage rate [1/s]"), std::string::npos);
  EXPECT_NE(text.find(",12.5,"), std::string::npos);
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), static_cast<std::ptrdiff_t>(results.station_s.size()) + 1);
}

TEST(fatigue_files, a_rate_that_is_no_number_is_not_written) {
  const StaticResults& statics = testing::solved_case("BGL1-T250").results;
  DynamicResults results = with_fatigue(statics);
  EXPECT_NO_THROW(require_finite(results));
  results.fatigue->spots[1].rate[3] = std::nan("");
  EXPECT_THROW(require_finite(results), std::runtime_error);
}

}  // namespace
}  // namespace overbend
