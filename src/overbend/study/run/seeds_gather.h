/// Statistics over several realisations.
#pragma once

#include <span>

#include "results/dynamic_results.h"
#include "results/seeds_results.h"
#include "results/static_results.h"
#include "study/run/history_peaks.h"

namespace overbend {

inline constexpr std::size_t kMinRuns = 10;  ///< Minimum number of runs for fitting a distribution.

/// Returns the key values of a run; a J-lay has none of the overbend and supports. `fatigue`: the run counts fatigue.
std::vector<SeedQuantity> seed_quantities(const StaticResults& statics, bool fatigue = false);

/// Returns the values of one run, in the same order.
std::vector<double> seed_values(const StaticResults& statics, const DynamicResults& results, bool fatigue = false);

/// Statistics of a quantity over at least one run. The extremes of runs are taken as Gumbel distributed; the estimate
/// is for three hours for any duration [s] of a run: mode + scale ln(3 h/duration), with the sign reversed for minima.
SeedStatistics seed_statistics(std::span<const double> values, SeedExtreme extreme, double duration);

/// True if extremes of the quantity cannot be negative although a distribution gives such: a line carries no
/// compression.
bool never_negative(const std::string& quantity);

/// Fills `statistics` from `runs`; no three-hour extremes if one of them is not stationary.
void fill_statistics(SeedsResults& results);

/// Adds the estimates by average conditional exceedance rates (ACER) to `statistics`, for quantities that are extremes.
/// `peaks`: of the histories of each run, in the order of the runs.
void add_acer(SeedsResults& results, std::span<const std::vector<HistoryPeaks>> peaks);

}  // namespace overbend
