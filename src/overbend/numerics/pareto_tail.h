/// Peaks over a threshold: a generalised Pareto distribution of what the largest peaks exceed it by.
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
  std::size_t clusters = 0;  ///< Runs of peaks in succession above the threshold, of which the largest counts.
  double per_peak = 0.0;     ///< Clusters over all peaks [-].
  bool described = false;    ///< Its own exceedances pass for a sample of it.

  /// Share of the clusters whose largest is above a value.
  double above(double value) const;
  /// The value that `expected_peaks` peaks exceed once on average.
  double once_in(double expected_peaks) const;
};

/// Fit to the largest of peaks in order of time, by probability-weighted moments [hosking1987]. The threshold is the
/// lowest, from the one that `most` peaks exceed upwards, over which the clusters pass for a sample of the distribution
/// (upper_tail_distance, least_chance); where there is none, the highest that is left, over which 12 peaks stand. None
/// where there are fewer, or where they are all the same.
std::optional<ParetoTail> fit_pareto_tail(std::span<const double> peaks, std::size_t most);

/// `tail.once_in(expected_peaks)` with its 95 % confidence interval: of 400 fits to random samples (always the same
/// ones) of the distribution, the number of clusters drawn as well.
ConfidentEstimate confident(const ParetoTail& tail, double expected_peaks);

}  // namespace overbend
