#include "mechanics/winch.h"

#include <gtest/gtest.h>

#include <cmath>

namespace overbend {
namespace {

TEST(winch_table, of_a_move_starts_and_ends_at_rest_and_goes_its_way_at_its_speed) {
  LengthTable table;
  const double done = add_move(table, 10.0, 5.0, 0.1, 4.0);
  EXPECT_NEAR(done, 10.0 + 5.0 / 0.1 + 4.0, 1e-12);  // both ramps together go as far as one at full speed
  EXPECT_EQ(table.at(0.0).length, 0.0);
  EXPECT_EQ(table.at(10.0).rate, 0.0);
  EXPECT_NEAR(table.at(35.0).rate, 0.1, 1e-12);
  EXPECT_NEAR(table.at(12.0).rate, 0.05, 1e-12);
  EXPECT_NEAR(table.at(done).length, 5.0, 1e-12);
  EXPECT_EQ(table.at(done + 1.0).rate, 0.0);
}

TEST(winch_table, has_the_rate_of_its_length_everywhere_and_never_goes_back) {
  LengthTable table;
  add_move(table, 0.0, -3.0, 0.2, 5.0);
  add_move(table, 30.0, 0.4, 0.2, 5.0);  // too short a way for the speed
  constexpr double kStep = 1e-5;
  for (double t = -1.0; t < 45.0; t += 0.137) {
    const double slope = (table.at(t + kStep).length - table.at(t - kStep).length) / (2.0 * kStep);
    EXPECT_NEAR(table.at(t).rate, slope, 1e-7) << t;
    EXPECT_LE(std::abs(table.at(t).rate), 0.2 + 1e-12) << t;
    EXPECT_LE((t < 25.0 ? 1.0 : -1.0) * table.at(t).rate, 1e-12) << t;
  }
  EXPECT_NEAR(table.at(100.0).length, -2.6, 1e-12);
}

TEST(winch_table, through_rows_goes_through_them_and_beyond_none) {
  const LengthTable table = smooth_table({0.0, 10.0, 20.0, 40.0}, {1000.0, 1003.0, 1003.0, 998.0});
  EXPECT_NEAR(table.at(10.0).length, 1003.0, 1e-12);
  for (double t = 0.0; t < 40.0; t += 0.1) {
    EXPECT_LE(table.at(t).length, 1003.0 + 1e-12);
    EXPECT_GE(table.at(t).length, 998.0 - 1e-12);
  }
  EXPECT_EQ(table.at(0.0).rate, 0.0);
  EXPECT_EQ(table.at(40.0).rate, 0.0);
}

}  // namespace
}  // namespace overbend
