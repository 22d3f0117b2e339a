/// Peaks of the histories from which extremes over several runs are estimated: some hundred numbers per run, so that
/// the histories need not be kept.
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
  std::string name;         ///< Name of the history; "max_reaction" and "largest_mooring_tension": over all boxes and
                            ///< lines.
  bool is_minimum = false;  ///< True if the peaks are those of the history with its sign reversed.
  PeakRecord record;
};

/// Returns the peaks between up-crossings of the mean from t = 0 on; of the negative values if `smallest`. `time` [s]
/// is evenly spaced and as long as `values`. No peaks if a value is not a number.
PeakRecord find_peaks(std::span<const double> time, std::span<const double> values, bool is_minimum);

/// Returns the peaks of tension, stress, strain, roller load, offset and mooring tension, as far as the run has them.
/// The first column is the time; `values` returns a column by its index.
std::vector<HistoryPeaks> find_run_peaks(const std::vector<HistoryColumn>& columns,
                                         const std::function<std::vector<double>(std::size_t)>& values);

/// Reads the same from results.h5. Throws std::runtime_error if the file is not a results file.
std::vector<HistoryPeaks> find_run_peaks(const std::filesystem::path& h5);

/// Returns the peaks of a result, by its name in summary.json ("dynamic.overbend.max_von_mises") or in the table of
/// seeds ("overbend_max_von_mises"); nullptr if there are none.
const HistoryPeaks* find_result_peaks(const std::vector<HistoryPeaks>& peaks, const std::string& result);

/// Most probable three-hour extreme of a result from its peaks in several runs, each with its own list of histories.
/// Empty if a run has none or there are too few.
std::optional<AcerFit> fit_result_acer(std::span<const std::vector<HistoryPeaks>> runs, const std::string& result);

}  // namespace overbend
