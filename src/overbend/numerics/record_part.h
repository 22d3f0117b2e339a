/// Low-frequency and wave-frequency parts of a motion, and their combined extreme.
#pragma once

#include <span>

namespace overbend {

/// Heights above the mean of one part of a record (below the mean: negate the record).
struct PartHeights {
  double cycles = 0.0;       ///< Number of mean up-crossings of the record.
  double significant = 0.0;  ///< Mean of the highest third of the peaks between them.
  double maximum = 0.0;      ///< Most probable maximum in the reference time.
};

/// Returns the heights of equally spaced values, `step` [s] apart. With at least kMinPeaks peaks the maximum is the
/// estimate of numerics/extremes.h, which holds for regular motion as well; without an estimate, std sqrt(2 ln n), that
/// of n peaks of a narrow-banded Gaussian process in `reference_time` [s], but not below the maximum of the record.
PartHeights compute_heights(std::span<const double> values, double step, double reference_time);

/// Returns the most probable height of the sum: the larger of the low-frequency maximum with the significant
/// wave-frequency height, and the wave-frequency maximum with the significant low-frequency height (DNV-OS-E301 ch. 2
/// sec. 2, offsets and tensions of moored units).
double combined_height(const PartHeights& slow, const PartHeights& wave);

/// Returns the standard error of the standard deviation of a record relative to it: half of sqrt(2/T integral rho^2),
/// rho the autocorrelation of the record and T its length [bendat2010, 8.2.2]. It is the scatter between realisations
/// of the same process. 0 for a constant record. `step` [s]; `resolution` [s]: values are sampled no closer than this.
double deviation_error(std::span<const double> values, double step, double resolution);

}  // namespace overbend
