#include "seafiles/displaced_volume.h"

#include <gtest/gtest.h>

#include <numbers>

#include "hull/made_radiation.h"

namespace overbend {
namespace {

TEST(displaced_volume, of_a_box_is_length_times_beam_times_draught) {
  const auto estimate = displaced_volume(testing::bgl1_data(), {120.0, 5.182, 89.0});
  ASSERT_TRUE(estimate);
  EXPECT_NEAR(estimate->volume, 120.0 * 30.0 * 5.182, 0.002 * 18655.0);  // what the panels of the files miss
  EXPECT_LT(estimate->uncertainty, 0.01);
}

TEST(displaced_volume, is_not_known_without_waves_that_are_long_relative_to_the_hull) {
  HydrodynamicData data = testing::bgl1_data();
  EXPECT_FALSE(displaced_volume(data, {800.0, 5.182, 89.0}));
  data.excitation.heading.assign(data.excitation.heading.size(), 1.0);
  EXPECT_FALSE(displaced_volume(data, {120.0, 5.182, 89.0}));
}

}  // namespace
}  // namespace overbend
