/// Average conditional exceedance rates (ACER): most probable extreme in a given time from the peaks of several
/// records. docs/theory/statistics.md has the formulas.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "numerics/log_weibull.h"

namespace overbend {

/// Minimum number of peaks of all records together; below it nothing is fitted.
inline constexpr int kMinAcerPeaks = 300;
inline constexpr int kAcerOrders = 6;  ///< Number of orders k evaluated: conditions on up to five previous peaks.

/// Peaks of one realisation.
struct PeakRecord {
  std::vector<double> peaks;  ///< Maxima between successive up-crossings of the mean, in order of time.
  double duration = 0.0;      ///< Time from the first up-crossing to the last [s].
};

/// Rate at which a peak exceeds a level with the k - 1 peaks before it below: per peak.
struct AcerLevel {
  double level = 0.0;
  double rate = 0.0;             ///< eps_k [-]
  double low = 0.0, high = 0.0;  ///< 95 % confidence interval.
};

/// rate(level) = q exp(-a (level - b)^c) for levels from levels.front() on.
struct AcerTail {
  double q = 0.0, a = 0.0, b = 0.0, c = 0.0;

  double rate(double level) const;
  /// Returns the level with this rate; needs rate < q.
  double level(double rate) const;
};

struct AcerFit {
  int order = 1;                  ///< k
  int peaks = 0;                  ///< Number of peaks of all records.
  double expected_peaks = 0.0;    ///< Expected number of peaks in the reference time.
  double observed = 0.0;          ///< Maximum peak.
  std::vector<AcerLevel> levels;  ///< Levels used in the fit of the tail, ascending.
  AcerTail tail;
  ConfidentEstimate estimate;  ///< Most probable maximum in the reference time, 95 % confidence.
};

/// Returns eps_k at ascending levels (Naess & Gaidai 2009): of the peaks with k - 1 others before them in their record,
/// all below the level, the fraction that exceeds it. Confidence from the scatter of at least twenty parts of the
/// records, but at least as wide as that of independent exceedances. Levels range from the first to the last whose
/// confidence interval excludes zero.
std::vector<AcerLevel> exceedance_rates(std::span<const PeakRecord> records, int order, std::span<const double> levels);

/// Fits the tail (Naess & Gaidai 2009) for the lowest order beyond which higher orders agree within the confidence. The
/// interval is that of the jackknife over the parts of the records: bands refitted to the ends of the intervals, as in
/// the paper, contain the true value in only 70 to 85 % of cases. Empty with fewer than kMinAcerPeaks, identical
/// peaks, or no tail to fit. `reference_time` [s].
std::optional<AcerFit> fit_acer(std::span<const PeakRecord> records, double reference_time);

/// Fits minima: `records` hold the negated peaks of the records. Levels and estimate are negated back, those of the
/// tail are not.
std::optional<AcerFit> fit_acer_minimum(std::span<const PeakRecord> records, double reference_time);

}  // namespace overbend
