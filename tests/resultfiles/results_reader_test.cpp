#include "resultfiles/results_reader.h"

#include <gtest/gtest.h>

#include "resultfiles/results_writer.h"
#include "results/fields/static_tables.h"
#include "results/fields/static_values.h"
#include "support/result_visitors.h"
#include "support/solved_case.h"

namespace overbend {
namespace {

using testing::BitsVisitor;
using testing::kListBytes;
using testing::SizeVisitor;
using testing::solved_case;
using testing::TemporaryFolder;

TEST(field_lists, hold_every_member_of_the_tables) {
  SizeVisitor station, roller, row, support, section;
  visit_station<const Station>(Station{}, station);
  visit_roller<const RollerResult>(RollerResult{}, roller);
  visit_row<const RowResult>(RowResult{}, row);
  visit_support<const SupportResult>(SupportResult{}, support);
  visit_section<const DerivedSection>(DerivedSection{}, section);
  EXPECT_EQ(station.bytes, sizeof(Station));
  EXPECT_EQ(roller.bytes, sizeof(RollerResult));
  EXPECT_EQ(row.bytes + kListBytes, sizeof(RowResult));
  EXPECT_EQ(support.bytes + kListBytes, sizeof(SupportResult));
  EXPECT_EQ(section.bytes, sizeof(DerivedSection));
}

TEST(field_lists, hold_every_member_of_a_check) {
  SizeVisitor row, input, along, design;
  visit_check<const CheckRow>(CheckRow{}, row);
  visit_check_input<const CheckInput>(CheckInput{}, input);
  visit_check_along<const CheckAlong>(CheckAlong{}, along);
  visit_station_design<const StationDesign>(StationDesign{}, design);
  constexpr std::size_t kShared = 8;  // region and status, two words, share eight bytes
  EXPECT_EQ(row.bytes + kListBytes - kShared, sizeof(CheckRow));
  EXPECT_EQ(input.bytes, sizeof(CheckInput));
  EXPECT_EQ(along.bytes, sizeof(CheckAlong));
  EXPECT_EQ(design.bytes, sizeof(StationDesign));
}

TEST(field_lists, hold_every_single_value) {
  const StaticResults results;
  SizeVisitor all, touchdown, solve, extreme;
  visit_key_results(results, all);
  visit_sums(results, all);
  visit_scene(results, all);
  visit_touchdown(results.touchdown, touchdown);
  visit_solve(results.solve, solve);
  visit_extreme_fields<const Extreme>(ResultField{}, Extreme{}, extreme);
  int extremes = 0;
  visit_region(results.sagbend, [&](const ResultField&, const Extreme&) { ++extremes; });
  EXPECT_EQ(all.bytes + sizeof(results.touchdown) + sizeof(results.solve) + sizeof(results.overbend) +
                sizeof(results.tower) + sizeof(results.smallest_tension) + sizeof(results.sagbend) + kListBytes +
                kListBytes + kListBytes + sizeof(results.checks) + sizeof(results.moorings) + sizeof(results.hull),
            sizeof(StaticResults));
  EXPECT_EQ(touchdown.bytes, sizeof(Touchdown));
  EXPECT_EQ(solve.bytes, sizeof(SolveReport));
  EXPECT_EQ(extreme.bytes, sizeof(Extreme));
  EXPECT_EQ(extremes * sizeof(Extreme), sizeof(RegionResult));
}

std::string bits_of(const StaticResults& results) {
  BitsVisitor bits;
  visit_key_results(results, bits);
  visit_sums(results, bits);
  visit_scene(results, bits);
  visit_touchdown(results.touchdown, bits);
  visit_solve(results.solve, bits);
  const auto extreme = [&](const ResultField& f, const Extreme& e) { visit_extreme_fields(f, e, bits); };
  if (results.overbend) visit_region(*results.overbend, extreme);
  if (results.tower) visit_region(*results.tower, extreme);
  visit_extreme_fields(ResultField{}, results.smallest_tension, bits);
  visit_region(results.sagbend, extreme);
  for (const DerivedSection& section : results.sections) visit_section(section, bits);
  for (const Station& station : results.stations) visit_station(station, bits);
  for (const SupportResult& support : results.supports) {
    visit_support(support, bits);
    for (const RowResult& row : support.rows) {
      visit_row(row, bits);
      for (const RollerResult& roller : row.rollers) visit_roller(roller, bits);
    }
  }
  testing::visit_checks(results.checks, bits);
  return bits.text;
}

StoredStatics through_file(const StaticResults& results, const Description& description) {
  const TemporaryFolder folder;
  write_static_hdf5(results, description, folder / "results.h5");
  return read_static_results(folder / "results.h5");
}

TEST(results_reader, gives_back_an_s_lay_bit_for_bit) {
  const auto& [description, results] = solved_case("BGL1-T250");
  const StoredStatics stored = through_file(results, description);
  EXPECT_EQ(bits_of(stored.results), bits_of(results));
  EXPECT_EQ(stored.model_text, testing::file_text(testing::case_file("BGL1-T250")));
  EXPECT_GT(stored.results.checks.rows.size(), 10U);
}

TEST(results_reader, gives_back_a_j_lay_without_supports_and_overbend) {
  const auto& [description, results] = solved_case("J12-D400-T560");
  const StoredStatics stored = through_file(results, description);
  EXPECT_EQ(bits_of(stored.results), bits_of(results));
  EXPECT_FALSE(stored.results.overbend);
  EXPECT_FALSE(stored.results.stinger_tip_clearance);
  EXPECT_TRUE(stored.results.supports.empty());
}

TEST(results_reader, gives_back_the_tower_of_a_j_lay_and_the_part_of_the_current) {
  auto [description, results] = solved_case("J12-D400-T560");
  results.tower = results.sagbend;
  results.tower->von_mises.value = 1.5e9;
  results.stations.back().region = Region::tower;
  results.stations.back().current_lateral_moment = -7.0;
  EXPECT_EQ(bits_of(through_file(results, description).results), bits_of(results));
}

TEST(results_reader, keeps_rollers_with_their_rows_and_boxes) {
  StaticResults results = solved_case("BGL1-T250").results;
  RollerResult port;
  port.position = RollerPosition::port;
  port.lateral = -3.25;
  results.supports.at(1).rows.at(0).rollers.push_back(port);
  RowResult second;
  second.rollers.resize(3);
  second.rollers[2].position = RollerPosition::starboard;
  results.supports.at(1).rows.push_back(second);
  results.supports.at(1).has_sides = true;
  results.title = "Größe \"A\", 16\xe2\x80\xb3";
  EXPECT_EQ(bits_of(through_file(results, {}).results), bits_of(results));
}

TEST(results_reader, refuses_a_file_that_is_none_of_ours) {
  const TemporaryFolder folder;
  testing::write_file(folder / "a.h5", "not HDF5");
  EXPECT_THROW(read_static_results(folder / "a.h5"), std::runtime_error);
  EXPECT_THROW(read_static_results(folder / "missing.h5"), std::runtime_error);
}

}  // namespace
}  // namespace overbend
