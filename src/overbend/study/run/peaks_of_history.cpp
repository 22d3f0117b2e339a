#include "study/run/peaks_of_history.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/constants.h"
#include "numerics/extremes.h"
#include "resultfiles/dynamic/long_data_reader.h"

namespace overbend {
namespace {

/// A history and the results that are its extreme.
struct Kept {
  const char* history;
  bool smallest;
  const char *in_summary, *in_seeds;
};

constexpr std::array<Kept, 12> kKept = {
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

/// Several histories of which the largest value at each row is meant.
struct Together {
  const char *name, *begin, *end;
};
constexpr std::array<Together, 2> kTogether = {
    {{"largest_reaction", "support/", "/reaction"}, {"largest_mooring_tension", "mooring/", "/fairlead_tension"}}};

const Kept* kept_history(const std::string& name) {
  const auto found = std::ranges::find_if(kKept, [&](const Kept& kept) { return name == kept.history; });
  return found == kKept.end() ? nullptr : &*found;
}

void keep_largest(std::vector<double>& largest, const std::vector<double>& values) {
  if (largest.empty()) {
    largest = values;
    return;
  }
  for (std::size_t i = 0; i < values.size(); ++i) largest[i] = std::max(largest[i], values[i]);
}

void add(std::vector<HistoryPeaks>& all, std::span<const double> time, const Kept& kept,
         const std::vector<double>& values) {
  all.push_back({kept.history, kept.smallest, peaks_of_history(time, values, kept.smallest)});
}

/// Name without ".max" or ".min" at its end: of a value over time this stands for its extreme.
bool same_result(std::string_view kept, std::string_view wanted) {
  return kept == wanted || (kept.size() > 4 && kept.substr(0, kept.size() - 4) == wanted);
}

}  // namespace

PeakRecord peaks_of_history(std::span<const double> time, std::span<const double> values, bool smallest) {
  const auto first = static_cast<std::size_t>(std::ranges::lower_bound(time, 0.0) - time.begin());
  std::vector<double> counted;
  for (std::size_t i = first; i < values.size(); ++i) {
    if (!std::isfinite(values[i])) return {};
    counted.push_back(smallest ? -values[i] : values[i]);
  }
  if (counted.size() < 2) return {};
  const double step = (time.back() - time[first]) / static_cast<double>(counted.size() - 1);
  RecordPeaks peaks = peaks_between_up_crossings(counted);
  return {std::move(peaks.peaks), peaks.steps * step};
}

std::vector<HistoryPeaks> peaks_of_run(const std::vector<HistoryColumn>& columns,
                                       const std::function<std::vector<double>(std::size_t)>& values) {
  std::vector<HistoryPeaks> all;
  const std::vector<double> time = values(0);
  for (std::size_t i = 1; i < columns.size(); ++i) {
    if (const Kept* kept = kept_history(columns[i].name)) add(all, time, *kept, values(i));
  }
  for (const Together& group : kTogether) {
    std::vector<double> largest;
    for (std::size_t i = 1; i < columns.size(); ++i) {
      const std::string& name = columns[i].name;
      if (name.starts_with(group.begin) && name.ends_with(group.end)) keep_largest(largest, values(i));
    }
    if (!largest.empty()) add(all, time, *kept_history(group.name), largest);
  }
  return all;
}

std::vector<HistoryPeaks> peaks_of_run(const std::filesystem::path& h5) {
  std::vector<HistoryColumn> columns = {{"time", "s", ""}};
  for (HistoryColumn& column : read_history_columns(h5)) columns.push_back(std::move(column));
  return peaks_of_run(columns, [&](std::size_t i) { return read_history(h5, columns[i].name); });
}

const HistoryPeaks* peaks_of_result(const std::vector<HistoryPeaks>& peaks, const std::string& result) {
  for (const Kept& kept : kKept) {
    if (!same_result(kept.in_summary, result) && kept.in_seeds != result) continue;
    const auto found = std::ranges::find(peaks, kept.history, &HistoryPeaks::name);
    if (found != peaks.end()) return &*found;
  }
  return nullptr;
}

std::optional<AcerFit> acer_of_result(std::span<const std::vector<HistoryPeaks>> runs, const std::string& result) {
  std::vector<PeakRecord> records;
  bool smallest = false;
  for (const std::vector<HistoryPeaks>& run : runs) {
    const HistoryPeaks* peaks = peaks_of_result(run, result);
    if (peaks == nullptr) return std::nullopt;
    smallest = peaks->smallest;
    records.push_back(peaks->record);
  }
  return smallest ? fit_acer_smallest(records, kThreeHours) : fit_acer(records, kThreeHours);
}

}  // namespace overbend
