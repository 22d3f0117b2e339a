#include "checks/weld_path.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace overbend {
namespace {

constexpr LayPace kPace{12.0, 300.0, 60.0};

std::vector<double> stations(double length, std::size_t count) {
  std::vector<double> s;
  for (std::size_t i = 0; i < count; ++i) s.push_back(length * static_cast<double>(i) / static_cast<double>(count - 1));
  return s;
}

TEST(weld_path, an_even_rate_does_the_damage_of_the_time_on_the_way) {
  const std::vector<double> s = stations(480.0, 41), rate(41, 1e-6);
  const WeldPath path = weld_path(s, rate, kPace);
  EXPECT_NEAR(path.mean, 1e-6 * 480.0 / 12.0 * 360.0, 1e-12);
  EXPECT_NEAR(path.accumulated.front(), path.mean, 1e-15);
  EXPECT_EQ(path.accumulated.back(), 0.0);
  EXPECT_NEAR(path.accumulated[20], 0.5 * path.mean, 1e-12);
}

/// Against following welds in time, with stops at phases all over a joint.
TEST(weld_path, mean_and_worst_are_those_of_welds_followed_through_their_stops) {
  const std::vector<double> s = stations(400.0, 81);
  std::vector<double> rate;
  for (const double position : s) {
    rate.push_back(1e-6 * (1.0 + std::cos(0.21 * position)) + 5e-6 * std::exp(-std::pow((position - 230.0) / 6.0, 2)));
  }
  const auto rate_at = [&](double position) {
    const double i = std::floor(position / 5.0), fraction = position / 5.0 - i;
    const std::size_t left = std::min<std::size_t>(static_cast<std::size_t>(i), rate.size() - 2);
    return rate[left] + (position / 5.0 - static_cast<double>(left)) * (rate[left + 1] - rate[left]) + 0.0 * fraction;
  };
  double worst = 0.0, mean = 0.0;
  constexpr int kPhases = 2400, kPieces = 4000;
  double moving = 0.0;
  for (int i = 0; i < kPieces; ++i) moving += rate_at((i + 0.5) * 400.0 / kPieces) * 400.0 / kPieces / 12.0 * 60.0;
  for (int i = 0; i < kPhases; ++i) {
    double damage = moving;
    for (double position = 400.0 - 12.0 * i / kPhases; position >= 0.0; position -= 12.0)
      damage += 300.0 * rate_at(position);
    worst = std::max(worst, damage);
    mean += damage / kPhases;
  }
  const WeldPath path = weld_path(s, rate, kPace);
  EXPECT_NEAR(path.mean / mean, 1.0, 1e-3);    // phases and pieces of the sums here
  EXPECT_NEAR(path.worst / worst, 1.0, 1e-4);  // the phases tried here are 5 mm apart
  EXPECT_GT(path.worst, 1.02 * path.mean);
}

TEST(weld_path, a_peak_shorter_than_a_joint_is_met_by_the_worst_stop) {
  const std::vector<double> s = {0.0, 100.0, 101.0, 102.0, 300.0};
  const WeldPath path = weld_path(s, std::vector<double>{0.0, 0.0, 1e-5, 0.0, 0.0}, kPace);
  EXPECT_NEAR(path.worst, 300.0 * 1e-5 + 60.0 / 12.0 * 1e-5, 1e-12);
  EXPECT_NEAR(path.mean, 1e-5 * 360.0 / 12.0, 1e-12);
}

}  // namespace
}  // namespace overbend
