/// Robust statistics of a recorded channel, and detection of outliers.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

namespace overbend {

/// Returns the arithmetic mean.
double mean(const std::vector<double>& values);
/// Returns the standard deviation (divided by N).
double deviation(const std::vector<double>& values);
/// Returns the value that the fraction `share` (0 to 1) of the values lies below; 0 for an empty list.
double quantile(std::vector<double> values, double share);
double median(const std::vector<double>& values);
/// Returns the differences of consecutive values, one fewer than the values.
std::vector<double> differences(const std::vector<double>& values);
/// Returns the row of the value of largest magnitude.
std::size_t max_magnitude_row(const std::vector<double>& values);

/// True if the range of the values is at least 20 times their resolution.
bool finely_written(const std::vector<double>& values);

/// Returns the mean period between up-crossings of the median [s]; 0 with fewer than two crossings.
double crossing_period(const std::vector<double>& time, const std::vector<double>& values);

/// Physical bounds of rate and acceleration.
struct RateBounds {
  double rate, acceleration;
};

/// An implausible step between the previous row and `row`.
struct RecordJump {
  std::size_t row;
  double rate;          ///< Magnitude of the rate.
  double acceleration;  ///< Magnitude of the acceleration at its start.
  double of_usual;      ///< Rate relative to the median of all non-zero rates.
};

/// Returns steps beyond the bounds, and steps much larger than both the usual step and the steps around them.
std::vector<RecordJump> find_jumps(const std::vector<double>& time, const std::vector<double>& values,
                                   RateBounds bounds);

/// Range of rows with equal values.
struct EqualRun {
  std::size_t first, last;
};

/// Returns the longest run of equal values that is improbable for a motion with the rates of the neighbouring rows and
/// the resolution of the record.
std::optional<EqualRun> find_frozen_run(const std::vector<double>& time, const std::vector<double>& values);

/// Returns the fraction of rows that repeat the previous value; 0 if the other steps are near the resolution.
double held_share(const std::vector<double>& values);

/// Returns the probability that a row of a normally distributed motion is written as 0.
double chance_of_zero(const std::vector<double>& values);

}  // namespace overbend
