/// Extremes over the seeds of a study.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "results/study_results.h"
#include "study/run/peaks_of_history.h"

namespace overbend {

/// Whether an output is a largest (true) or smallest (false) value over a run; nothing where it is neither. Its name
/// says so: "max", "min", "largest", "smallest" as a word of it, or a utilisation.
std::optional<bool> looks_for_largest(const std::string& output);

/// Peaks of a case's histories; an empty list where there are none.
using PeaksOfCase = std::function<std::vector<HistoryPeaks>(const StudyCase&)>;

/// Fills `extremes`: an entry for every group of at least two finished cases with seeds and every output that is an
/// extreme. Gumbel from kFewestRuns runs on, ACER where the histories of all of them have peaks enough. `duration` of
/// each run [s].
void fill_extremes(StudyResults& results, double duration, const PeaksOfCase& peaks = {});

}  // namespace overbend
