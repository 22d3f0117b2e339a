/// Histories as the results keep them: thinned, with their statistics.
#pragma once

#include <span>
#include <vector>

#include "runstore/run_store.h"

namespace overbend {

inline constexpr std::size_t kMostStretches = 2000;

/// Least and greatest of each of at most kMostStretches equal stretches of the rows, which are equally spaced in time
/// (fewer rows: each row alone), and the statistics of the rows from t = 0 on (all zero where there is none). `time`
/// and `values` are of one length.
HistorySummary summarise_history(const HistoryColumn& column, std::span<const double> time,
                                 std::span<const double> values);

/// All histories of a run but the first column, the time, in the order of the columns.
std::vector<HistorySummary> summarise_histories(const RunStore& store);

}  // namespace overbend
