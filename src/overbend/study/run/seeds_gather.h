/// From the results of several realisations to what they say together.
#pragma once

#include <span>

#include "results/dynamic_results.h"
#include "results/seeds_results.h"
#include "results/static_results.h"
#include "study/run/peaks_of_history.h"

namespace overbend {

inline constexpr std::size_t kFewestRuns = 10;  ///< Below this no distribution is fitted.

/// The key values of a run; a J-lay has none of the overbend and of supports. `fatigue`: of runs that count it.
std::vector<SeedQuantity> seed_quantities(const StaticResults& statics, bool fatigue = false);

/// Those of one run, in the same order.
std::vector<double> seed_values(const StaticResults& statics, const DynamicResults& results, bool fatigue = false);

/// A quantity over the runs, at least one. A run's extreme is taken for a Gumbel variable; the estimate
/// is for three hours, whatever the duration [s] of a run: mode + scale ln(3 h/duration), turned for smallest values.
SeedStatistics seed_statistics(std::span<const double> values, SeedExtreme extreme, double duration);

/// Of the quantities above: whether no extreme of it is below zero, whatever a distribution says. A line bears no push.
bool never_negative(const std::string& quantity);

/// Fills `statistics` from `runs`; no extreme of three hours where one of them is not stationary.
void fill_statistics(SeedsResults& results);

/// Adds the estimates by average conditional exceedance rates to `statistics`, where the quantity is an extreme.
/// `peaks`: of every run's histories, in the order of the runs.
void add_acer(SeedsResults& results, std::span<const std::vector<HistoryPeaks>> peaks);

}  // namespace overbend
