/// Peaks of the histories from which extremes over several runs are estimated: some hundred numbers of a run, so that
/// its histories need not be kept.
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "numerics/acer.h"
#include "results/dynamic_sink.h"

namespace overbend {

struct HistoryPeaks {
  std::string name;       ///< Of the history; "largest_reaction" and "largest_mooring_tension" of all boxes and lines.
  bool smallest = false;  ///< The peaks are those of the history with its sign turned.
  PeakRecord record;
};

/// Peaks between up-crossings of the mean from t = 0 on; of the negative where `smallest` values are wanted. `time` [s]
/// is evenly spaced and as long as `values`. No peaks where a value is not a number.
PeakRecord peaks_of_history(std::span<const double> time, std::span<const double> values, bool smallest);

/// Of tension, stress, strain, roller load, offset and mooring tension, as far as the run has them. The first column is
/// the time; `values` gives one by its index.
std::vector<HistoryPeaks> peaks_of_run(const std::vector<HistoryColumn>& columns,
                                       const std::function<std::vector<double>(std::size_t)>& values);

/// The same from results.h5. Throws std::runtime_error where the file is none of ours.
std::vector<HistoryPeaks> peaks_of_run(const std::filesystem::path& h5);

/// The peaks that belong to a result, by its name in summary.json ("dynamic.overbend.max_von_mises") or in the table of
/// seeds ("overbend_max_von_mises"); nullptr where there are none.
const HistoryPeaks* peaks_of_result(const std::vector<HistoryPeaks>& peaks, const std::string& result);

/// Most probable extreme of three hours from one result's peaks in several runs, each with its own list of histories.
/// None where a run has none or they are too few.
std::optional<AcerFit> acer_of_result(std::span<const std::vector<HistoryPeaks>> runs, const std::string& result);

}  // namespace overbend
