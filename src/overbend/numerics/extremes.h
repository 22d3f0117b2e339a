/// Most probable maximum in a given time, from the peaks of a record. docs/theory/statistics.md has the formulas.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "numerics/log_weibull.h"

namespace overbend {

inline constexpr int kMinPeaks = 30;  ///< Minimum number of peaks; below it nothing is fitted.

/// Maxima between successive up-crossings of the mean.
struct RecordPeaks {
  std::vector<double> peaks;  ///< In order of time.
  double mean = 0.0;          ///< Mean of the record.
  double steps = 0.0;         ///< Number of steps from the first up-crossing to the last.
  /// Fraction of the cycles that reach the minimum of the record, as the force of an intermittent contact does.
  double fraction_at_minimum = 0.0;
};

/// Returns the maxima between successive up-crossings of the mean of equally spaced values.
RecordPeaks peaks_between_up_crossings(std::span<const double> values);

/// Method of an estimate.
enum class ExtremeMethod {
  none,
  regular,   ///< Equal peaks, as in a regular wave.
  weibull,   ///< Weibull distribution of the upper half of the peaks.
  pareto,    ///< Generalised Pareto distribution of the peaks over a threshold.
  observed,  ///< Maximum observed in a record of the reference time or longer.
};

/// Quality of an estimate.
enum class ExtremeQuality { good, uncertain, none };

/// Reason for reduced quality.
enum class ExtremeDoubt {
  none,
  few_peaks,
  rare,     ///< The quantity stays at its minimum between peaks: its maxima are from rare events.
  no_tail,  ///< No distribution fits the largest peaks.
  wide,     ///< Wide confidence interval.
};

struct ExtremeFit {
  int peaks = 0;
  double observed = 0.0;       ///< Maximum of the record (of the peaks, if only they are given).
  bool enough = false;         ///< False if there are too few peaks; all estimates are then the observed value.
  ConfidentEstimate estimate;  ///< Most probable maximum, 95 % confidence, by `method`.
  ExtremeMethod method = ExtremeMethod::none;  ///< None: there is no estimate, only the observed value.
  ExtremeQuality quality = ExtremeQuality::none;
  ExtremeDoubt doubt = ExtremeDoubt::few_peaks;
  ConfidentEstimate weibull;  ///< Estimates by each distribution, regardless of its fit.
  ConfidentEstimate gumbel;
  std::optional<ConfidentEstimate> pareto;  ///< Set if the Weibull distribution does not fit.
  bool weibull_describes = false;           ///< True if the largest peaks are consistent with the Weibull distribution.
  // Weibull distribution of (peak - mean): F(x) = 1 - exp(-(x/scale)^shape). 0 if not fitted.
  double weibull_scale = 0.0, weibull_shape = 0.0;
  // Gumbel distribution of the maximum peak of a block: F(x) = exp(-exp(-(x - mode)/scale)). 0 if not fitted.
  double gumbel_mode = 0.0, gumbel_scale = 0.0;
  int peaks_per_block = 0;
};

/// Fits distributions to peaks in order of time. Weibull: maximum likelihood on the upper half of the peaks, as
/// distances from `mean`; the lower half counts by its number only, so that ripples about the mean do not distort the
/// tail. Gumbel: maximum likelihood on the maxima of blocks of consecutive peaks, with as many blocks as the square
/// root of the number of peaks, but at least ten. `expected_peaks` is the number of peaks in the reference time, > 1.
/// The Weibull estimate is used if the distribution fits the largest peaks, else that of a generalised Pareto tail; it
/// is not below the maximum peak of a record shorter than half of the reference time. `rare`: peaks are from events
/// between which the quantity is constant: their values are not extrapolated. If the larger peaks are equal, as in a
/// regular wave, the estimate is that value.
ExtremeFit fit_peaks(std::span<const double> peaks, double mean, double expected_peaks, bool rare = false);

/// Returns the most probable maximum in `reference_time` [s] of a record with values `step` [s] apart.
ExtremeFit fit_extremes(std::span<const double> values, double step, double reference_time);

/// Returns the most probable minimum, by negating the record and the result. `gumbel_mode` is negated as well; the
/// Weibull distribution is of (mean - peak).
ExtremeFit fit_minimum(std::span<const double> values, double step, double reference_time);

}  // namespace overbend
