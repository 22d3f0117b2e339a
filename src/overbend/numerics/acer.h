/// Average conditional exceedance rates (ACER): most probable extreme of a time from the peaks of several records.
/// docs/theory/statistics.md has the formulas.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "numerics/log_weibull.h"

namespace overbend {

inline constexpr int kFewestAcerPeaks = 300;  ///< Of all records together; below this nothing is fitted.
inline constexpr int kAcerOrders = 6;         ///< Orders k that are looked at: conditions on up to five peaks before.

/// Of one realisation.
struct PeakRecord {
  std::vector<double> peaks;  ///< The largest value between each two up-crossings of the mean, in order of time.
  double duration = 0.0;      ///< From the first up-crossing to the last [s].
};

/// How often a level is exceeded by a peak, the k - 1 peaks before it being below: per peak.
struct AcerLevel {
  double level = 0.0;
  double rate = 0.0;             ///< eps_k [-]
  double low = 0.0, high = 0.0;  ///< 95 % confidence.
};

/// rate(level) = q exp(-a (level - b)^c) from levels.front() on.
struct AcerTail {
  double q = 0.0, a = 0.0, b = 0.0, c = 0.0;

  double rate(double level) const;
  /// The level with this rate; needs rate < q.
  double level(double rate) const;
};

struct AcerFit {
  int order = 1;                  ///< k
  int peaks = 0;                  ///< Of all records.
  double expected_peaks = 0.0;    ///< In the reference time.
  double observed = 0.0;          ///< Largest peak.
  std::vector<AcerLevel> levels;  ///< Ascending, those that the tail is fitted to.
  AcerTail tail;
  ConfidentEstimate estimate;  ///< Most probable largest value in the reference time, 95 % confidence.
};

/// eps_k at ascending levels (Naess & Gaidai 2009): of the peaks with k - 1 others before them in their record, all of
/// them below the level, the fraction that exceeds it. Confidence from the scatter of at least twenty parts of the
/// records, but no narrower than that of independent exceedances. From the first to the last level that its confidence
/// interval tells from zero.
std::vector<AcerLevel> exceedance_rates(std::span<const PeakRecord> records, int order, std::span<const double> levels);

/// Fits the tail (Naess & Gaidai 2009) for the least order beyond which conditions on more peaks change nothing within
/// the confidence. The interval is that of the jackknife over the parts of the records: bands refitted to the ends of
/// the intervals, as the paper has them, hold the truth in 70 to 85 % only. None with fewer than kFewestAcerPeaks,
/// peaks that are all the same, or no tail to fit. `reference_time` [s].
std::optional<AcerFit> fit_acer(std::span<const PeakRecord> records, double reference_time);

/// The same of smallest values: `records` hold the peaks of the records with their sign turned. Levels and estimate
/// are turned back, those of the tail are not.
std::optional<AcerFit> fit_acer_smallest(std::span<const PeakRecord> records, double reference_time);

}  // namespace overbend
