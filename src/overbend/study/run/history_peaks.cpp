#include "study/run/history_peaks.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/constants.h"
#include "base/ranges.h"
#include "numerics/extremes.h"
#include "resultfiles/dynamic/long_data_reader.h"

namespace overbend {
namespace {

/// A history and the results that are its extreme.
struct ExtremeHistory {
  const char* history;
  bool is_minimum;
  const char *in_summary, *in_seeds;
};

constexpr std::array<ExtremeHistory, 12> kExtremeHistories = {
    {{"top_tension_peak", false, "dynamic.top_tension.max", "top_tension_max"},
     {"top_tension_low", true, "dynamic.top_tension.min", "top_tension_min"},
     {"smallest_tension", true, "dynamic.smallest_tension.min", "smallest_tension"},
     {"overbend_von_mises_peak", false, "dynamic.overbend.max_von_mises", "overbend_max_von_mises"},
     {"overbend_strain_peak", false, "dynamic.overbend.max_strain", "overbend_max_strain"},
     {"tower_von_mises_peak", false, "dynamic.tower.max_von_mises", "tower_max_von_mises"},
     {"tower_strain_peak", false, "dynamic.tower.max_strain", "tower_max_strain"},
     {"sagbend_von_mises_peak", false, "dynamic.sagbend.max_von_mises", "sagbend_max_von_mises"},
     {"sagbend_strain_peak", false, "dynamic.sagbend.max_strain", "sagbend_max_strain"},
     {"vessel/offset", false, "dynamic.vessel.offset.max", "largest_offset"},
     {"largest_reaction", false, "dynamic.largest_reaction.max", "largest_reaction"},
     {"largest_mooring_tension", false, "dynamic.largest_mooring_tension.max", "largest_mooring_tension"}}};

/// Several histories whose maximum at each row is evaluated.
struct CombinedHistory {
  const char *name, *begin, *end;
};
constexpr std::array<CombinedHistory, 2> kCombinedHistories = {
    {{"largest_reaction", "support/", "/reaction"}, {"largest_mooring_tension", "mooring/", "/fairlead_tension"}}};

const ExtremeHistory* find_extreme_history(const std::string& name) {
  const auto found =
      ranges::find_if(kExtremeHistories, [&](const ExtremeHistory& kept) { return name == kept.history; });
  return found == kExtremeHistories.end() ? nullptr : &*found;
}

void update_maxima(std::vector<double>& maxima, const std::vector<double>& values) {
  if (maxima.empty()) {
    maxima = values;
    return;
  }
  for (std::size_t i = 0; i < values.size(); ++i) maxima[i] = std::max(maxima[i], values[i]);
}

void add(std::vector<HistoryPeaks>& all, std::span<const double> time, const ExtremeHistory& kept,
         const std::vector<double>& values) {
  all.push_back({kept.history, kept.is_minimum, find_peaks(time, values, kept.is_minimum)});
}

/// True if the names are equal, also without ".max" or ".min" at the end: a history's name stands for its extreme.
bool same_result(std::string_view kept, std::string_view wanted) {
  return kept == wanted || (kept.size() > 4 && kept.substr(0, kept.size() - 4) == wanted);
}

}  // namespace

PeakRecord find_peaks(std::span<const double> time, std::span<const double> values, bool is_minimum) {
  const auto first = static_cast<std::size_t>(ranges::lower_bound(time, 0.0) - time.begin());
  std::vector<double> counted;
  for (std::size_t i = first; i < values.size(); ++i) {
    if (!std::isfinite(values[i])) return {};
    counted.push_back(is_minimum ? -values[i] : values[i]);
  }
  if (counted.size() < 2) return {};
  const double step = (time.back() - time[first]) / static_cast<double>(counted.size() - 1);
  RecordPeaks peaks = peaks_between_up_crossings(counted);
  return {std::move(peaks.peaks), peaks.steps * step};
}

std::vector<HistoryPeaks> find_run_peaks(const std::vector<HistoryColumn>& columns,
                                         const std::function<std::vector<double>(std::size_t)>& values) {
  std::vector<HistoryPeaks> all;
  const std::vector<double> time = values(0);
  for (std::size_t i = 1; i < columns.size(); ++i) {
    if (const ExtremeHistory* kept = find_extreme_history(columns[i].name)) add(all, time, *kept, values(i));
  }
  for (const CombinedHistory& group : kCombinedHistories) {
    std::vector<double> maxima;
    for (std::size_t i = 1; i < columns.size(); ++i) {
      const std::string& name = columns[i].name;
      if (name.starts_with(group.begin) && name.ends_with(group.end)) update_maxima(maxima, values(i));
    }
    if (!maxima.empty()) add(all, time, *find_extreme_history(group.name), maxima);
  }
  return all;
}

std::vector<HistoryPeaks> find_run_peaks(const std::filesystem::path& h5) {
  std::vector<HistoryColumn> columns = {{"time", "s", ""}};
  for (HistoryColumn& column : read_history_columns(h5)) columns.push_back(std::move(column));
  return find_run_peaks(columns, [&](std::size_t i) { return read_history(h5, columns[i].name); });
}

const HistoryPeaks* find_result_peaks(const std::vector<HistoryPeaks>& peaks, const std::string& result) {
  for (const ExtremeHistory& kept : kExtremeHistories) {
    if (!same_result(kept.in_summary, result) && kept.in_seeds != result) continue;
    const auto found = ranges::find(peaks, kept.history, &HistoryPeaks::name);
    if (found != peaks.end()) return &*found;
  }
  return nullptr;
}

std::optional<AcerFit> fit_result_acer(std::span<const std::vector<HistoryPeaks>> runs, const std::string& result) {
  std::vector<PeakRecord> records;
  bool is_minimum = false;
  for (const std::vector<HistoryPeaks>& run : runs) {
    const HistoryPeaks* peaks = find_result_peaks(run, result);
    if (peaks == nullptr) return std::nullopt;
    is_minimum = peaks->is_minimum;
    records.push_back(peaks->record);
  }
  return is_minimum ? fit_acer_minimum(records, kThreeHours) : fit_acer(records, kThreeHours);
}

}  // namespace overbend
