/// Histories of the results: reduced, with statistics.
#pragma once

#include <span>
#include <vector>

#include "runstore/run_store.h"

namespace overbend {

inline constexpr std::size_t kMaxIntervals = 2000;

/// Minimum and maximum of each of at most kMaxIntervals equal intervals of the rows, which are equally spaced in time
/// (fewer rows: each row alone), and statistics of the rows from t = 0 on (all zero if there are none). `time` and
/// `values` have the same length.
HistorySummary summarise_history(const HistoryColumn& column, std::span<const double> time,
                                 std::span<const double> values);

/// Summaries of all histories of a run except the first column, time, in the order of the columns.
std::vector<HistorySummary> summarise_histories(const RunStore& store);

}  // namespace overbend
