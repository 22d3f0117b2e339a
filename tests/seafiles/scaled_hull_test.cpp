// RAOs of a hull scaled from those of another.
#include "seafiles/scaled_hull.h"

#include <gtest/gtest.h>

#include <cmath>

#include "base/constants.h"
#include "seafiles/rao_reader.h"
#include "support/rao_files.h"

namespace overbend {
namespace {

using testing::bgl1_raos;
using testing::good_raos;
using testing::WrittenFile;

constexpr HullDimensions kBarge{120.0, 30.0};
constexpr double kHeading = 150.0 * kDegree;

TEST(scaled_hull, the_same_dimensions_leave_every_value_as_it_was) {
  const RaoTable same = scale_raos(bgl1_raos(), kBarge, kBarge);
  ASSERT_EQ(same.values.size(), bgl1_raos().values.size());
  for (std::size_t i = 0; i < same.values.size(); ++i) {
    EXPECT_NEAR(std::abs(same.values[i] - bgl1_raos().values[i]), 0.0, 1e-12);
  }
}

TEST(scaled_hull, four_times_the_size_doubles_periods_and_quarters_rotations) {
  const RaoTable large = scale_raos(bgl1_raos(), kBarge, {480.0, 120.0});
  EXPECT_EQ(large.omegas.size(), bgl1_raos().omegas.size());
  EXPECT_NEAR(large.reference_V.z(), 4.0 * 0.818, 1e-12);
  for (const double omega : {0.15, 0.4, 0.77, 1.31}) {
    const RaoTable::Response small = bgl1_raos().at(kHeading, omega), scaled = large.at(kHeading, 0.5 * omega);
    for (std::size_t k = 0; k < 6; ++k) {
      EXPECT_NEAR(std::abs(scaled[k] - small[k] / (k < 3 ? 1.0 : 4.0)), 0.0, 1e-12) << k;
    }
  }
}

TEST(scaled_hull, sway_and_roll_follow_the_beam_and_the_others_the_length) {
  const RaoTable wide = scale_raos(bgl1_raos(), kBarge, {120.0, 67.5});
  const double omega = 0.66, turned = omega * 1.5;  // sqrt(67.5/30) = 1.5
  const RaoTable::Response was = bgl1_raos().at(kHeading, omega), beam = bgl1_raos().at(kHeading, turned);
  const RaoTable::Response is = wide.at(kHeading, omega);
  // Frequencies of both ratios are among the new ones, so that a straight line in the complex plane stays one.
  for (const std::size_t k : {0U, 2U, 4U, 5U}) EXPECT_NEAR(std::abs(is[k] - was[k]), 0.0, 1e-12) << k;
  EXPECT_NEAR(std::abs(is[1] - beam[1]), 0.0, 1e-12);
  EXPECT_NEAR(std::abs(is[3] - beam[3] / 2.25), 0.0, 1e-12);
}

TEST(scaled_hull, long_waves_still_turn_the_hull_by_their_slope) {
  // A hull that follows the slope k a of long waves, k = omega^2/g in deep water.
  RaoTable slopes;
  slopes.headings = {0.5 * kPi};
  for (int i = 1; i <= 40; ++i) {
    const double omega = 0.005 * i, slope = omega * omega / kGravity;
    slopes.omegas.push_back(omega);
    for (const double value : {0.0, 1.0, 1.0, slope, slope, 0.0}) slopes.values.emplace_back(value);
  }
  const RaoTable scaled = scale_raos(slopes, kBarge, {200.0, 36.0});
  for (const double omega : {0.03, 0.07, 0.12}) {
    const RaoTable::Response z = scaled.at(0.5 * kPi, omega);
    EXPECT_NEAR(z[2].real(), 1.0, 1e-12);
    EXPECT_NEAR(z[3].real(), omega * omega / kGravity, 1e-6);  // linear between frequencies
    EXPECT_NEAR(z[4].real(), omega * omega / kGravity, 1e-6);
  }
}

TEST(scaled_hull, its_file_is_read_as_the_same_table_with_the_assumption) {
  const RaoTable scaled = scale_raos(bgl1_raos(), kBarge, {150.0, 32.0});
  const WrittenFile file("scaled.csv", rao_csv(scaled, "A hull", "The hull is scaled."));
  const RaoTable read = good_raos(file.path());
  ASSERT_EQ(read.values.size(), scaled.values.size());
  for (std::size_t i = 0; i < read.values.size(); ++i) {
    EXPECT_NEAR(std::abs(read.values[i] - scaled.values[i]), 0.0, 2e-5 * (0.01 + std::abs(scaled.values[i])));
  }
  EXPECT_NEAR((read.reference_V - scaled.reference_V).norm(), 0.0, 1e-5);
  ASSERT_EQ(read.assumptions.size(), 1U);
  EXPECT_EQ(read.assumptions[0], (Assumption{AssumptionRank::governing, "The hull is scaled."}));
}

}  // namespace
}  // namespace overbend
