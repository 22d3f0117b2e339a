#include "numerics/rainflow.h"

#include <gtest/gtest.h>

#include <map>
#include <random>

#include "support/allocation_count.h"

namespace overbend {
namespace {

using Cycles = std::vector<RainflowCycle>;

/// Cycles of a record in the order in which they close.
Cycles counted(const std::vector<double>& record, double hysteresis = 0.0) {
  Cycles cycles;
  const auto keep = [&](std::size_t, const RainflowCycle& cycle) { cycles.push_back(cycle); };
  RainflowCounter counter(1, hysteresis);
  for (const double value : record) counter.add(std::span(&value, 1), keep);
  counter.residue(keep);
  return cycles;
}

/// Count by range.
std::map<double, double> by_range(const Cycles& cycles) {
  std::map<double, double> counts;
  for (const RainflowCycle& cycle : cycles) counts[cycle.range] += cycle.count;
  return counts;
}

std::vector<double> turning_points(const std::vector<double>& record) {
  std::vector<double> points = {record.front()};
  for (std::size_t i = 1; i + 1 < record.size(); ++i) {
    if ((record[i] - points.back()) * (record[i + 1] - record[i]) < 0.0) points.push_back(record[i]);
  }
  points.push_back(record.back());
  return points;
}

/// Another method: of four points in a row, the middle range is a cycle if it lies within both neighbours; all over the
/// record, again and again; what is left are half cycles (the four-point method, Amzallag et al. 1994).
Cycles four_point_cycles(const std::vector<double>& record) {
  std::vector<double> points = turning_points(record);
  Cycles cycles;
  for (bool found = true; found;) {
    found = false;
    for (std::size_t i = 0; i + 3 < points.size(); ++i) {
      const double before = std::abs(points[i + 1] - points[i]), middle = std::abs(points[i + 2] - points[i + 1]);
      const double after = std::abs(points[i + 3] - points[i + 2]);
      if (middle > before || middle > after) continue;
      cycles.push_back({middle, 0.5 * (points[i + 1] + points[i + 2]), 1.0});
      points.erase(points.begin() + static_cast<std::ptrdiff_t>(i) + 1,
                   points.begin() + static_cast<std::ptrdiff_t>(i) + 3);
      found = true;
      break;
    }
  }
  for (std::size_t i = 1; i < points.size(); ++i) {
    cycles.push_back({std::abs(points[i] - points[i - 1]), 0.5 * (points[i] + points[i - 1]), 0.5});
  }
  return cycles;
}

/// A walk of random steps that is drawn back to zero.
std::vector<double> random_record(unsigned seed, std::size_t length) {
  std::mt19937 random(seed);
  std::normal_distribution<double> step;
  std::vector<double> record = {step(random)};
  while (record.size() < length) record.push_back(0.7 * record.back() + step(random));
  return record;
}

const std::vector<double> kWithEnds = {0, -2, 1, -3, 5, -1, 3, -4, 4, -2, 0};

TEST(rainflow, counts_of_the_example_of_astm_e1049) {
  const std::vector<double> example(kWithEnds.begin() + 1, kWithEnds.end() - 1);
  const std::map<double, double> expected = {{3, 0.5}, {4, 1.5}, {6, 0.5}, {8, 1.0}, {9, 0.5}};
  EXPECT_EQ(by_range(counted(example)), expected);
}

TEST(rainflow, cycles_of_the_example_come_in_the_order_of_the_standard) {
  const std::vector<double> counts = {0.5, 0.5, 0.5, 1.0, 0.5, 0.5, 0.5, 0.5, 0.5};
  const std::vector<double> means = {-1, -0.5, -1, 1, 1, 0.5, 0, 1, -1};
  const Cycles cycles = counted(kWithEnds);
  ASSERT_EQ(cycles.size(), counts.size());
  for (std::size_t i = 0; i < cycles.size(); ++i) {
    EXPECT_EQ(cycles[i].count, counts[i]) << i;
    EXPECT_EQ(cycles[i].mean, means[i]) << i;
  }
}

TEST(rainflow, random_records_have_the_cycles_of_the_four_point_method) {
  for (unsigned seed = 1; seed <= 40; ++seed) {
    const std::vector<double> record = random_record(seed, 150 + seed);
    const auto ours = by_range(counted(record)), theirs = by_range(four_point_cycles(record));
    ASSERT_EQ(ours.size(), theirs.size()) << seed;
    auto second = theirs.begin();
    for (const auto& [range, count] : ours) {
      EXPECT_EQ(range, second->first) << seed;
      EXPECT_EQ(count, (second++)->second) << seed;
    }
  }
}

TEST(rainflow, a_record_that_is_split_anywhere_and_taken_up_again_has_the_same_cycles) {
  const std::vector<double> record = random_record(7, 120);
  const Cycles whole = counted(record);
  for (std::size_t split = 0; split <= record.size(); ++split) {
    Cycles cycles;
    const auto keep = [&](std::size_t, const RainflowCycle& cycle) { cycles.push_back(cycle); };
    RainflowCounter first(1), second(1);
    for (std::size_t i = 0; i < split; ++i) first.add(std::span(&record[i], 1), keep);
    second.restore(first.save());
    for (std::size_t i = split; i < record.size(); ++i) second.add(std::span(&record[i], 1), keep);
    second.residue(keep);
    ASSERT_EQ(cycles.size(), whole.size()) << split;
    for (std::size_t i = 0; i < whole.size(); ++i) {
      EXPECT_EQ(cycles[i].range, whole[i].range);
      EXPECT_EQ(cycles[i].count, whole[i].count);
    }
  }
}

TEST(rainflow, records_side_by_side_do_not_mix) {
  constexpr std::size_t kRecords = 11;
  std::vector<std::vector<double>> records;
  for (unsigned i = 0; i < kRecords; ++i) records.push_back(random_record(100 + i, 200));
  std::vector<Cycles> together(kRecords);
  const auto keep = [&](std::size_t record, const RainflowCycle& cycle) { together[record].push_back(cycle); };
  RainflowCounter counter(kRecords);
  std::vector<double> sample(kRecords);
  for (std::size_t i = 0; i < 200; ++i) {
    for (std::size_t record = 0; record < kRecords; ++record) sample[record] = records[record][i];
    counter.add(sample, keep);
  }
  counter.residue(keep);
  for (std::size_t record = 0; record < kRecords; ++record) {
    EXPECT_EQ(by_range(together[record]), by_range(counted(records[record])));
  }
}

/// Turns of the record smaller than the hysteresis are ignored; the rest keeps its size.
TEST(rainflow, ranges_within_the_hysteresis_are_passed_over_and_larger_ones_are_whole) {
  std::vector<double> trembling;
  for (const double value : kWithEnds) {
    for (const double tremble : {0.0, 0.01, -0.01, 0.0}) trembling.push_back(value + tremble);
  }
  std::map<double, double> rounded;
  for (const auto& [range, count] : by_range(counted(trembling, 0.05))) rounded[std::round(range)] += count;
  EXPECT_EQ(rounded, by_range(counted(kWithEnds)));
  EXPECT_TRUE(counted({1.0, 1.04, 1.0, 1.03}, 0.05).empty());
}

TEST(rainflow, a_record_that_goes_straight_is_half_a_cycle) {
  const Cycles cycles = counted({0.0, 1.0, 2.0, 7.0});
  ASSERT_EQ(cycles.size(), 1U);
  EXPECT_EQ(cycles[0].range, 7.0);
  EXPECT_EQ(cycles[0].count, 0.5);
  EXPECT_TRUE(counted({3.0, 3.0, 3.0}).empty());
}

double cubes(const Cycles& cycles) {
  double sum = 0.0;
  for (const RainflowCycle& cycle : cycles) sum += cycle.count * std::pow(cycle.range, 3);
  return sum;
}

/// Ranges that shrink from one to the next all wait: more than there is room for.
TEST(rainflow, ranges_that_shrink_for_longer_than_there_is_room_do_a_little_more_damage_and_never_less) {
  std::vector<double> record;
  for (int i = 0; i < 600; ++i) record.push_back((i % 2 == 0 ? 1.0 : -1.0) * (600.0 - i));
  const double dying = cubes(counted(record)) / cubes(four_point_cycles(record));
  EXPECT_GE(dying, 1.0);
  EXPECT_LE(dying, 1.03);
  for (int i = 600; i-- > 0;) record.push_back((i % 2 == 0 ? 1.0 : -1.0) * (600.5 - i));
  const double grown = cubes(counted(record)) / cubes(four_point_cycles(record));
  EXPECT_GE(grown, 1.0);
  EXPECT_LE(grown, 1.03);
  record.push_back(1000.0);  // what has waited is closed, and the largest range is that of the record
  record.push_back(-1000.0);
  EXPECT_EQ(by_range(counted(record)).rbegin()->first, 2000.0);
}

TEST(rainflow, counting_allocates_nothing) {
  RainflowCounter counter(16);
  std::vector<double> sample(16);
  const std::vector<double> record = random_record(3, 500);
  double sum = 0.0;
  const long before = testing::allocation_count();
  for (const double value : record) {
    std::fill(sample.begin(), sample.end(), value);
    counter.add(sample, [&](std::size_t, const RainflowCycle& cycle) { sum += cycle.range; });
  }
  EXPECT_EQ(testing::allocation_count(), before);
  EXPECT_GT(sum, 0.0);
}

TEST(rainflow, a_stored_count_that_does_not_fit_is_rejected) {
  RainflowCounter counter(2);
  counter.add(std::vector<double>{1.0, 2.0}, [](std::size_t, const RainflowCycle&) {});
  std::vector<double> saved = counter.save();
  EXPECT_THROW(RainflowCounter(3).restore(saved), std::out_of_range);
  saved.pop_back();
  EXPECT_THROW(RainflowCounter(2).restore(saved), std::out_of_range);
}

}  // namespace
}  // namespace overbend
