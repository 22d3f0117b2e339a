#include "model/site/monotone_cubic.h"

#include <gtest/gtest.h>

namespace overbend {
namespace {

TEST(monotone_cubic, slopes_between_even_knots_are_harmonic_means) {
  const std::vector<double> slopes = monotone_slopes({0.0, 2.0, 4.0, 6.0}, {0.0, 2.0, 8.0, 9.0});
  EXPECT_DOUBLE_EQ(slopes[1], 2.0 * 1.0 * 3.0 / 4.0);  // secants 1, 3, 0.5
  EXPECT_DOUBLE_EQ(slopes[2], 2.0 * 3.0 * 0.5 / 3.5);
  EXPECT_DOUBLE_EQ(slopes[0], 0.0);  // (3 - 3) / 2: of the three-point formula
  EXPECT_DOUBLE_EQ(slopes[3], 0.0);  // (3 * 0.5 - 3) / 2 has the other sign
}

TEST(monotone_cubic, weights_its_harmonic_mean_by_the_lengths_of_uneven_intervals) {
  // Intervals 1 and 3, secants 2 and 0.5: weights 2*3+1 = 7 and 3+2*1 = 5, (7+5)/(7/2+5/0.5) = 12/13.5.
  const std::vector<double> slopes = monotone_slopes({0.0, 1.0, 4.0}, {0.0, 2.0, 3.5});
  EXPECT_DOUBLE_EQ(slopes[1], 12.0 / 13.5);
  EXPECT_DOUBLE_EQ(slopes[0], ((2.0 * 1.0 + 3.0) * 2.0 - 1.0 * 0.5) / 4.0);
  EXPECT_DOUBLE_EQ(slopes[2], 0.0);  // ((2*3+1)*0.5 - 3*2)/4 < 0
}

TEST(monotone_cubic, is_level_at_extremes_and_where_it_stays_level) {
  const std::vector<double> slopes = monotone_slopes({0.0, 1.0, 2.0, 3.0, 4.0}, {0.0, 1.0, 0.5, 0.5, 0.5});
  EXPECT_EQ(slopes[1], 0.0);
  EXPECT_EQ(slopes[2], 0.0);
  EXPECT_EQ(slopes[3], 0.0);
  EXPECT_EQ(slopes[4], 0.0);
}

TEST(monotone_cubic, end_slope_is_at_most_three_secants_where_the_next_turns_back) {
  // Secants 1 and -9 over even intervals: (3*1 + 9)/2 = 6 is limited to 3.
  EXPECT_DOUBLE_EQ(monotone_slopes({0.0, 1.0, 2.0}, {0.0, 1.0, -8.0})[0], 3.0);
}

TEST(monotone_cubic, through_two_points_is_a_straight_line) {
  EXPECT_EQ(monotone_slopes({1.0, 3.0}, {5.0, 4.0}), (std::vector<double>{-0.5, -0.5}));
}

}  // namespace
}  // namespace overbend
