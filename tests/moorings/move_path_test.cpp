#include "moorings/move_path.h"

#include <gtest/gtest.h>

#include "moorings/bgl1_spread.h"

namespace overbend {
namespace {

MoveProfile joint_ahead() {
  MoveProfile profile;
  profile.distance = 12.0;
  profile.start = 20.0;
  return profile;
}

/// Lengths at all places of one joint ahead.
LengthsByDistance joint_lengths(BargeAtWork& barge) {
  LengthsByDistance lengths;
  for (const double distance : move_positions(joint_ahead())) {
    const HullEquilibrium rest =
        plan_lengths(barge.spread, barge.hull, offset_ahead(HullOffset::Zero(), distance), barge.wished);
    EXPECT_FALSE(rest.error) << *rest.error;
    lengths.add(distance, barge.spread);
  }
  return lengths;
}

TEST(move_path, of_a_joint_hauls_and_pays_out_what_the_closed_form_says) {
  BargeAtWork barge;
  const LengthsByDistance lengths = joint_lengths(barge);
  ASSERT_EQ(lengths.distances.size(), 25U);
  const double change[] = {-10.90, -5.02, 5.17, 10.96};
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_NEAR(lengths.lengths.back()[i] - lengths.lengths.front()[i], change[i], 0.0055);  // two digits given
  }
}

TEST(move_path, between_its_places_has_the_lengths_of_the_plan_there) {
  BargeAtWork barge;
  const LengthsByDistance lengths = joint_lengths(barge);
  for (const double distance : {0.2, 5.9, 11.75}) {
    plan_lengths(barge.spread, barge.hull, offset_ahead(HullOffset::Zero(), distance), barge.wished);
    for (std::size_t i = 0; i < 8; ++i) {
      EXPECT_NEAR(lengths.at(i, distance).length, barge.spread.lines[i].line.first_segment(), 1e-5) << distance;
      const double slope = (lengths.at(i, distance + 1e-4).length - lengths.at(i, distance - 1e-4).length) / 2e-4;
      EXPECT_NEAR(lengths.at(i, distance).slope, slope, 1e-7);
    }
  }
}

TEST(move_path, in_time_starts_and_ends_at_rest_and_goes_with_the_hull) {
  BargeAtWork barge;
  const LengthsByDistance lengths = joint_lengths(barge);
  const MoveProfile profile = joint_ahead();
  const std::vector<LengthTable> tables = winch_tables(lengths, profile);
  ASSERT_EQ(tables.size(), 8U);
  for (std::size_t i = 0; i < tables.size(); ++i) {
    const LengthTable& table = tables[i];
    EXPECT_EQ(table.rates.front(), 0.0);
    EXPECT_EQ(table.rates.back(), 0.0);
    EXPECT_EQ(table.times.front(), 20.0);
    EXPECT_NEAR(table.times.back(), 110.0, 1e-12);
    for (double t = 15.0; t < 115.0; t += 0.37) {
      EXPECT_NEAR(table.at(t).length, lengths.at(i, profile.at(t).distance).length, 1e-7) << t;
      EXPECT_NEAR(table.at(t).rate, (table.at(t + 1e-4).length - table.at(t - 1e-4).length) / 2e-4, 2e-6) << t;
    }
  }
}

TEST(move_path, of_several_joints_is_one_table_with_rests_between_them) {
  BargeAtWork barge;
  LengthsByDistance lengths;
  MoveProfile profile = joint_ahead();
  profile.moves = 2;
  profile.wait = 60.0;
  for (const double distance : move_positions(profile)) {
    plan_lengths(barge.spread, barge.hull, offset_ahead(HullOffset::Zero(), distance), barge.wished);
    lengths.add(distance, barge.spread);
  }
  const std::vector<LengthTable> tables = winch_tables(lengths, profile);
  for (std::size_t i = 0; i < tables.size(); ++i) {
    EXPECT_NEAR(tables[i].at(140.0).length, lengths.lengths[24][i], 1e-9);
    EXPECT_EQ(tables[i].at(140.0).rate, 0.0);
    EXPECT_NEAR(tables[i].at(1e4).length, lengths.lengths[48][i], 1e-9);
  }
}

}  // namespace
}  // namespace overbend
