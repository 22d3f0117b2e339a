/// Peaks over a threshold: generalised Pareto distribution of the excess of the largest peaks.
///
///     F(y) = 1 - (1 + shape y/scale)^(-1/shape),    y = peak - threshold
#pragma once

#include <cstddef>
#include <optional>
#include <span>

#include "numerics/log_weibull.h"

namespace overbend {

struct ParetoTail {
  double threshold = 0.0, scale = 1.0, shape = 0.0;
  /// Number of clusters: runs of successive peaks above the threshold, of which the maximum counts.
  std::size_t clusters = 0;
  double per_peak = 0.0;   ///< Ratio of clusters to all peaks [-].
  bool described = false;  ///< True if its own excesses are consistent with a sample of it.

  /// Returns the fraction of the clusters whose maximum is above a value.
  double above(double value) const;
  /// Returns the value that is exceeded once on average in `expected_peaks` peaks.
  double once_in(double expected_peaks) const;
};

/// Fits to the largest of peaks in order of time, by probability-weighted moments [hosking1987]. The threshold is the
/// lowest, from the one exceeded by `max_count` peaks upwards, over which the clusters are consistent with a sample of
/// the distribution (upper_tail_distance, min_probability); if there is none, the highest, exceeded by 12 peaks. Empty
/// if there are fewer peaks, or if they are all equal.
std::optional<ParetoTail> fit_pareto_tail(std::span<const double> peaks, std::size_t max_count);

/// Returns `tail.once_in(expected_peaks)` with its 95 % confidence interval from 400 fits to random samples (fixed
/// seed) of the distribution, with a random number of clusters.
ConfidentEstimate confident(const ParetoTail& tail, double expected_peaks);

}  // namespace overbend
