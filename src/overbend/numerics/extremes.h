/// Most probable largest value in a given time, from the peaks of a record. docs/theory/statistics.md has the formulas.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "numerics/log_weibull.h"

namespace overbend {

inline constexpr int kFewestPeaks = 30;  ///< Below this nothing is fitted.

/// The largest value between each two up-crossings of the mean.
struct RecordPeaks {
  std::vector<double> peaks;  ///< In order of time.
  double mean = 0.0;          ///< Of the record.
  double steps = 0.0;         ///< From the first up-crossing to the last.
  /// Share of the cycles that come down to the least value of the record, as the force of a contact that opens does.
  double at_least = 0.0;
};

RecordPeaks peaks_between_up_crossings(std::span<const double> values);

/// What an estimate was made by.
enum class ExtremeMethod {
  none,
  regular,   ///< The larger peaks are the same.
  weibull,   ///< A Weibull distribution of the upper half of the peaks.
  pareto,    ///< A generalised Pareto distribution of the peaks over a threshold.
  observed,  ///< The largest peaks of a record of the reference time or more.
};

/// What it is worth.
enum class ExtremeQuality { good, uncertain, none };

/// Why it is not good.
enum class ExtremeDoubt {
  none,
  few_peaks,
  rare,     ///< The quantity rests at its least value between peaks: its largest ones are of rare events.
  no_tail,  ///< No distribution describes the largest peaks.
  wide,     ///< The confidence interval.
};

struct ExtremeFit {
  int peaks = 0;
  double observed = 0.0;                       ///< Largest of the record (of the peaks, where only they are given).
  bool enough = false;                         ///< False: too few peaks; all estimates are then the observed value.
  ConfidentEstimate estimate;                  ///< Most probable largest value, 95 % confidence, by `method`.
  ExtremeMethod method = ExtremeMethod::none;  ///< None: there is no estimate, it is the observed value.
  ExtremeQuality quality = ExtremeQuality::none;
  ExtremeDoubt doubt = ExtremeDoubt::few_peaks;
  ConfidentEstimate weibull;  ///< By each distribution, whether it describes the peaks or not.
  ConfidentEstimate gumbel;
  std::optional<ConfidentEstimate> pareto;  ///< Where the Weibull distribution does not describe them.
  bool weibull_describes = false;           ///< The largest peaks pass for those of the Weibull distribution.
  // Of the Weibull distribution of (peak - mean): F(x) = 1 - exp(-(x/scale)^shape). 0 where not fitted.
  double weibull_scale = 0.0, weibull_shape = 0.0;
  // Of the Gumbel distribution of the largest peak of a block: F(x) = exp(-exp(-(x - mode)/scale)). 0 where not fitted.
  double gumbel_mode = 0.0, gumbel_scale = 0.0;
  int peaks_per_block = 0;
};

/// From peaks in order of time. Weibull: maximum likelihood on the upper half of the peaks, as distances from `mean`;
/// the lower half counts by its number only, so that ripples about the mean do not bend the tail. Gumbel: maximum
/// likelihood on the largest of blocks of consecutive peaks, as many blocks as the root of the number of peaks, but at
/// least ten. `expected_peaks` is the number of peaks in the time for which the largest value is wanted, > 1. The
/// estimate is Weibull's where its distribution describes the largest peaks, else that of a generalised Pareto tail; it
/// is not below the largest peak of a record shorter than half of that time. `rare`: peaks are of events between
/// which the quantity rests: what they reach is not extrapolated. When the larger peaks are equal, as in a regular
/// wave, the estimate is that value.
ExtremeFit fit_peaks(std::span<const double> peaks, double mean, double expected_peaks, bool rare = false);

/// Most probable largest value in `reference_time` [s] of a record with values `step` [s] apart.
ExtremeFit fit_extremes(std::span<const double> values, double step, double reference_time);

/// Most probable smallest value: that of the record with its sign turned, turned back. `gumbel_mode` is turned back as
/// well; the Weibull distribution is of (mean - peak).
ExtremeFit fit_smallest(std::span<const double> values, double step, double reference_time);

}  // namespace overbend
