#include "seafiles/heading_table_builder.h"

#include <gtest/gtest.h>

#include "base/constants.h"

namespace overbend {
namespace {

/// Half a circle of headings of a hull that is symmetric but for `noise` in sway along its axis.
HeadingTableBuilder half_circle(double noise) {
  HeadingTableBuilder builder;
  for (int h = 0; h <= 180; h += 45) {
    const double s = std::sin(h * kDegree);
    builder.add(0.5, h * kDegree, 0, std::cos(h * kDegree));
    builder.add(0.5, h * kDegree, 1, s + (h % 180 == 0 ? noise : 0.0));
    builder.add(0.5, h * kDegree, 2, 40.0);
  }
  return builder;
}

TEST(heading_table_builder, the_rounding_of_a_symmetric_mesh_vanishes_in_the_mean_of_both_sides) {
  for (const double noise : {0.0, 5e-5, 2e-4, 5e-3}) {
    std::string error;
    const auto built = half_circle(noise).build(true, error);
    ASSERT_TRUE(built) << error;
    ASSERT_EQ(built->table.heading.size(), 8U);
    EXPECT_LT(std::abs(built->values[0](1)), 1e-15) << noise;
    EXPECT_NEAR(built->values[6](1).real(), -1.0, 1e-15);  // 270 deg
  }
}

TEST(heading_table_builder, a_hull_that_is_not_symmetric_is_said_to_be_so) {
  std::string error;
  EXPECT_FALSE(half_circle(0.05).build(true, error));
  EXPECT_NE(error.find("a hull that is not symmetric"), std::string::npos) << error;
  EXPECT_NE(error.find("mode 2"), std::string::npos) << error;
}

TEST(heading_table_builder, a_mode_that_is_all_noise_is_small_relative_to_the_other_moments) {
  HeadingTableBuilder builder;
  for (int h = 0; h <= 180; h += 45) {
    builder.add(0.5, h * kDegree, 4, 100.0 * std::cos(h * kDegree));
    builder.add(0.5, h * kDegree, 5, 1e-3);
  }
  std::string error;
  EXPECT_TRUE(builder.build(true, error)) << error;
}

TEST(heading_table_builder, a_heading_that_is_given_twice_has_to_agree) {
  HeadingTableBuilder builder;
  builder.add(0.5, 0.0, 2, 1.0);
  builder.add(0.5, kTurn, 2, 1.01);
  std::string error;
  EXPECT_FALSE(builder.build(false, error));
  EXPECT_NE(error.find("two different values"), std::string::npos);
}

}  // namespace
}  // namespace overbend
