/// A part of a motion, slow or of the waves, and what two of them reach together.
#pragma once

#include <span>

namespace overbend {

/// Heights above the mean of one part of a record (below it: the same with the sign turned).
struct PartHeights {
  double cycles = 0.0;       ///< Mean up-crossings of the record.
  double significant = 0.0;  ///< Mean of the highest third of the peaks between them.
  double largest = 0.0;      ///< Most probable largest of the reference time.
};

/// Of equally spaced values, `step` [s] apart. With at least kFewestPeaks peaks the largest is the estimate of
/// numerics/extremes.h, which holds for regular motion as well; where that has none, std sqrt(2 ln n), that of n peaks
/// of a narrow-banded Gaussian process in `reference_time` [s], but not below the highest of the record.
PartHeights heights_of(std::span<const double> values, double step, double reference_time);

/// Most probable height of the sum: the larger of the slow part's largest with the waves' significant height, and the
/// waves' largest with the slow part's significant height (DNV-OS-E301 ch. 2 sec. 2, offsets and tensions of moored
/// units).
double combined_height(const PartHeights& slow, const PartHeights& wave);

/// Standard error of the standard deviation of a record, as a share of it: half of sqrt(2/T integral rho^2), rho the
/// autocorrelation of the record and T its length [bendat2010, 8.2.2]. What another realisation of the same process
/// would scatter by. 0 for a record that never changes. `step` [s], `resolution` [s]: the values are looked at no
/// closer.
double deviation_error(std::span<const double> values, double step, double resolution);

}  // namespace overbend
