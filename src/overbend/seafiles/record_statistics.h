/// Statistics of a recorded channel that a few wrong rows do not change, and what stands out against them.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

namespace overbend {

double mean(const std::vector<double>& values);
/// Standard deviation.
double deviation(const std::vector<double>& values);
/// `share` from 0 to 1 of the values are below; 0 of an empty list.
double quantile(std::vector<double> values, double share);
double median(const std::vector<double>& values);
/// Each value minus the one before: one less than the values.
std::vector<double> differences(const std::vector<double>& values);
/// Row of the value of largest magnitude.
std::size_t largest(const std::vector<double>& values);

/// Whether the range of the values is many times their last digit.
bool finely_written(const std::vector<double>& values);

/// Mean period between crossings of the mean upwards [s]; 0 with fewer than two crossings.
double crossing_period(const std::vector<double>& time, const std::vector<double>& values);

/// Rate and acceleration beyond which nothing moves.
struct RateBounds {
  double rate, acceleration;
};

/// A step from the row before `row` that is no motion.
struct Leap {
  std::size_t row;
  double rate;          ///< Magnitudes.
  double acceleration;  ///< Of the change of rate with which it begins.
  double of_usual;      ///< Rate over the median of all that are not zero.
};

/// Steps beyond the bounds, and steps that are far larger than the usual one and than those around them.
std::vector<Leap> find_leaps(const std::vector<double>& time, const std::vector<double>& values, RateBounds bounds);

/// Rows of one value.
struct EqualRun {
  std::size_t first, last;
};

/// The longest run of equal values in a channel that moves otherwise, where the motion beside it, written with as many
/// digits, cannot stand so still.
std::optional<EqualRun> find_frozen_run(const std::vector<double>& time, const std::vector<double>& values);

/// Share of the rows that repeat the value before in a channel that otherwise changes by many last digits.
double held_share(const std::vector<double>& values);

/// Chance that a row of a normally distributed motion is written as 0.
double chance_of_zero(const std::vector<double>& values);

}  // namespace overbend
