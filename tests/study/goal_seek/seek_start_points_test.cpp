#include "study/goal_seek/seek_start_points.h"

#include <gtest/gtest.h>

namespace overbend {
namespace {

using Eigen::VectorXd;

TEST(seek_places, of_two_unknowns_are_corners_middle_and_twenty_draws_the_nearest_first) {
  const VectorXd original = VectorXd::Constant(2, 0.25);
  const std::vector<VectorXd> places = start_points_within_bounds(original);
  ASSERT_EQ(places.size(), 25U);
  int corners = 0, middles = 0;
  for (std::size_t i = 0; i < places.size(); ++i) {
    const VectorXd& x = places[i];
    EXPECT_GE(x.minCoeff(), 0.0);
    EXPECT_LE(x.maxCoeff(), 1.0);
    if (i > 0) {
      EXPECT_GE((x - original).norm(), (places[i - 1] - original).norm());
    }
    const bool corner = (x(0) == 0.0 || x(0) == 1.0) && (x(1) == 0.0 || x(1) == 1.0);
    corners += corner ? 1 : 0;
    middles += x == VectorXd::Constant(2, 0.5) ? 1 : 0;
  }
  EXPECT_EQ(corners, 4);
  EXPECT_EQ(middles, 1);
}

TEST(seek_places, of_many_unknowns_have_no_corners_and_stay_few) {
  EXPECT_EQ(start_points_within_bounds(VectorXd::Constant(13, 0.5)).size(), 61U);
}

}  // namespace
}  // namespace overbend
