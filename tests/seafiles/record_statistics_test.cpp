#include "seafiles/record_statistics.h"

#include <gtest/gtest.h>

#include <cmath>

#include "base/constants.h"

namespace overbend {
namespace {

struct Channel {
  std::vector<double> time, values;
};

constexpr double kPeriod = 7.31;  // [s], no multiple of the step: the smallest change is the last digit

/// A sine in rows of 0.5 s, with a last digit.
Channel sine(int rows, double digit) {
  Channel channel;
  for (int i = 0; i < rows; ++i) {
    channel.time.push_back(0.5 * i);
    channel.values.push_back(digit * std::round(std::sin(kTurn / kPeriod * (0.5 * i + 0.13)) / digit));
  }
  return channel;
}

TEST(record_statistics, deviation_and_period_of_a_sine) {
  const Channel channel = sine(1600, 1e-6);
  EXPECT_NEAR(mean(channel.values), 0.0, 3e-3);  // half a period more than 109: at most 1 / (109 pi)
  EXPECT_NEAR(deviation(channel.values), std::sqrt(0.5), 5e-3);
  EXPECT_NEAR(crossing_period(channel.time, channel.values), kPeriod, 0.5 / 100.0);
}

TEST(record_statistics, a_run_is_frozen_by_the_digits_with_which_it_is_written) {
  const auto found = [](double digit) {
    Channel channel = sine(1600, digit);
    for (std::size_t i = 800; i < 806; ++i) channel.values[i] = 0.0;
    return find_frozen_run(channel.time, channel.values);
  };
  ASSERT_TRUE(found(1e-4));
  EXPECT_EQ(found(1e-4)->first, 800U);
  EXPECT_EQ(found(1e-4)->last, 805U);
  EXPECT_FALSE(found(0.5));
  const Channel sound = sine(1600, 1e-4);
  EXPECT_FALSE(find_frozen_run(sound.time, sound.values));
}

TEST(record_statistics, the_chance_of_a_zero_is_that_of_the_last_digit_at_the_mean) {
  // density of the normal distribution at its mean, 0.4 over the deviation, times the digit
  EXPECT_NEAR(chance_of_zero({0.0, 1.0, 0.0, -1.0}), 0.4 / std::sqrt(0.5), 1e-12);
  EXPECT_EQ(chance_of_zero({0.0, 0.0, 0.0}), 1.0);
}

TEST(record_statistics, held_rows_are_those_between_steps_of_many_digits) {
  EXPECT_NEAR(held_share({0.0, 0.0, 1.0, 1.0, 2.5, 2.5, 2.4, 2.4, 4.0}), 0.5, 1e-12);
  EXPECT_EQ(held_share({0.0, 0.0, 0.1, 0.1, 0.2, 0.2, 0.1, 0.1}), 0.0);  // slow, in tenths
}

}  // namespace
}  // namespace overbend
