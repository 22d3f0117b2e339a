/// Extremes over the seeds of a study.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "results/study_results.h"
#include "study/run/history_peaks.h"

namespace overbend {

/// Returns true if an output is a maximum over a run, false for a minimum, empty for neither, from its name: "max",
/// "min", "largest", "smallest" as a part of it, or a utilisation.
std::optional<bool> is_maximum_output(const std::string& output);

/// Peaks of a case's histories; an empty list if there are none.
using PeaksOfCase = std::function<std::vector<HistoryPeaks>(const StudyCase&)>;

/// Fills `extremes`: an entry for every group of at least two finished cases with seeds and every output that is an
/// extreme. Gumbel from kMinRuns runs on, ACER if the histories of all of them have enough peaks. `duration` of each
/// run [s].
void fill_extremes(StudyResults& results, double duration, const PeaksOfCase& peaks = {});

}  // namespace overbend
