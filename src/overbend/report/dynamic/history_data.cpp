#include "report/dynamic/history_data.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <set>

#include "report/dynamic/mooring_histories.h"
#include "report/page/json_number.h"
#include "report/page/key_statistics.h"
#include "report/page/quantity.h"
#include "report/page/static_value.h"

namespace overbend {
namespace {

constexpr std::size_t kMaxIntervals = 1000;  ///< about the width of a figure in points
constexpr std::size_t kMaxSupports = 4;
constexpr double kLevels = 4095.0;

const HistorySummary* find(const DynamicResults& results, const std::string& name) {
  const auto found = std::find_if(results.histories.begin(), results.histories.end(),
                                  [&](const HistorySummary& h) { return h.name == name; });
  return found == results.histories.end() ? nullptr : &*found;
}

/// Merges neighbouring intervals until at most the given number remain; NaN is a missing value.
std::vector<double> merge_intervals(const std::vector<double>& values, bool maxima) {
  const std::size_t each = (values.size() + kMaxIntervals - 1) / kMaxIntervals;
  std::vector<double> out;
  for (std::size_t i = 0; i < values.size(); i += each) {
    const auto first = values.begin() + static_cast<std::ptrdiff_t>(i);
    const auto last = values.begin() + static_cast<std::ptrdiff_t>(std::min(i + each, values.size()));
    out.push_back(std::accumulate(first, last, std::numeric_limits<double>::quiet_NaN(),
                                  [&](double a, double b) { return maxima ? std::fmax(a, b) : std::fmin(a, b); }));
  }
  return out;
}

struct Range {
  double lo = std::numeric_limits<double>::infinity(), hi = -std::numeric_limits<double>::infinity();
  void widen(const std::vector<double>& values) {
    for (const double value : values) {
      if (std::isfinite(value)) {
        lo = std::min(lo, value);
        hi = std::max(hi, value);
      }
    }
  }
  bool empty() const { return lo > hi; }
};

Json levels(const std::vector<double>& values, const Range& range) {
  Json out = Json::array();
  const double width = range.hi - range.lo;
  for (const double value : values) {
    if (!std::isfinite(value)) {
      out.push_back(nullptr);
    } else {
      out.push_back(width > 0.0 ? static_cast<int>(std::lround(kLevels * (value - range.lo) / width)) : 0);
    }
  }
  return out;
}

Json spread_data(const SummaryStatistics& spread, const Quantity& q) {
  return {{"min", json_number(q.shown(spread.min))},
          {"max", json_number(q.shown(spread.max))},
          {"mean", json_number(q.shown(spread.mean))},
          {"std", json_number(q.shown(spread.std))}};
}

/// True if it varies by more than the last digit shown.
bool varies_visibly(const Spectrum& spectrum, double total, const Quantity& q) {
  const double step = spectrum.frequency.back() / static_cast<double>(spectrum.frequency.size());
  return q.shown(std::sqrt(total * step)) > 0.5 * std::pow(10.0, -q.digits);
}

/// Title of a spectrum; for a mooring line only its name, which is long: the unit shows that it is a tension.
std::string spectrum_title(const std::string& history, const Quantity& q) {
  const std::string mooring = "mooring/", tension = "/fairlead_tension";
  if (!history.starts_with(mooring) || !history.ends_with(tension)) return q.name;
  return history.substr(mooring.size(), history.size() - mooring.size() - tension.size());
}

/// Selection of histories: each once, only those with values.
class Histories {
 public:
  Histories(const StaticResults& statics, const DynamicResults& results) : statics_(statics), results_(results) {}

  bool add(const std::string& group, const HistorySummary* history) {
    if (history == nullptr || history->low.empty() || history->low.size() != history->high.size()) {
      return false;
    }
    const Quantity q = quantity(history->name, history->units);
    Json trace = history_trace(*history, q);
    if (trace.is_null()) {
      return false;
    }
    const std::optional<double> before = static_value(statics_, results_, history->name);
    trace.update({{"group", group},
                  {"title", q.name},
                  {"unit", q.unit},
                  {"digits", q.digits},
                  {"description", history->description},
                  {"over_time", spread_data(key_statistics(results_, history->name).value_or(history->over_time), q)},
                  {"static", before ? json_number(q.shown(*before)) : Json(nullptr)}});
    out_.push_back(std::move(trace));
    return true;
  }

  bool add(const std::string& group, const std::string& name) { return add(group, find(results_, name)); }

  /// Adds a history that varies: calm water or a fixed vessel has nothing to show.
  void add_moving(const std::string& group, const std::string& name) {
    const HistorySummary* history = find(results_, name);
    if (history != nullptr && history->over_time.min < history->over_time.max) add(group, history);
  }

  /// Adds the peaks between rows, which are more informative than the values at the rows.
  void add_peak(const std::string& group, const std::string& name) {
    if (!add(group, name + "_peak")) {
      add(group, name);
    }
  }

  /// Adds minima at the rows and maxima between them: loss of tension is as important as its peaks.
  bool add_between(const std::string& group, const std::string& name) {
    const HistorySummary* rows = find(results_, name);
    const HistorySummary* peaks = find(results_, name + "_peak");
    if (rows == nullptr || peaks == nullptr || rows->high.size() != peaks->high.size()) return add(group, name);
    HistorySummary both = *rows;
    both.high = peaks->high;
    return add(group, &both);
  }

  /// Shades a range of values of the history added last.
  void shade(double low, double high) {
    if (high > low && !out_.empty()) {
      const Quantity q = quantity("tensioner/tension", "N");
      out_.back()["shade"] = {json_number(q.shown(low)), json_number(q.shown(high))};
    }
  }

  Json take() { return std::move(out_); }

 private:
  const StaticResults& statics_;
  const DynamicResults& results_;
  Json out_ = Json::array();
};

std::vector<const HistorySummary*> hardest_supports(const DynamicResults& results) {
  std::vector<const HistorySummary*> all;
  for (const SupportDynamics& box : results.supports) {
    if (const HistorySummary* history = find(results, "support/" + box.name + "/reaction")) {
      all.push_back(history);
    }
  }
  std::stable_sort(all.begin(), all.end(), [](const HistorySummary* a, const HistorySummary* b) {
    return a->over_time.max > b->over_time.max;
  });
  all.resize(std::min(all.size(), kMaxSupports));
  return all;
}

}  // namespace

Json history_trace(const HistorySummary& history, const Quantity& q) {
  const std::vector<double> low = merge_intervals(history.low, false);
  const std::vector<double> high = merge_intervals(history.high, true);
  Range range;
  range.widen(low);
  range.widen(high);
  if (range.empty()) {
    return nullptr;
  }
  return {{"lowest", json_number(q.shown(range.lo))},
          {"quantum", json_number(q.shown(range.hi - range.lo) / kLevels)},
          {"low", levels(low, range)},
          {"high", levels(high, range)}};
}

Json history_data(const StaticResults& statics, const DynamicResults& results) {
  Histories histories(statics, results);
  histories.add_moving("wave", "elevation");
  for (const char* freedom : {"surge", "sway", "heave", "roll", "pitch", "yaw"}) {
    histories.add_moving("motions", freedom);
  }
  histories.add_between("tension", "top_tension");
  histories.add("tension", "bottom_tension");
  if (results.tensioner.mode != "locked") {  // a locked tensioner has no motion, and its tension is the pipe's top
                                             // tension
    histories.add("tensioner", "tensioner/tension");
    histories.shade(results.tensioner.range_low, results.tensioner.range_high);
    histories.add("tensioner", "tensioner/travel");
  }
  if (statics.overbend) {
    histories.add_peak("stress", "overbend_von_mises");
  }
  histories.add_peak("stress", "sagbend_von_mises");
  for (const HistorySummary* history : hardest_supports(results)) {
    histories.add("reactions", history);
  }
  if (statics.stinger_tip_clearance) {
    histories.add("separation", "stinger_tip_clearance");
  }
  for (const StingerSectionDynamics& section : results.stinger) {
    const std::string of = "stinger/" + section.name + "/";
    histories.add("stinger_angle", of + "angle");
    histories.add("stinger_hinge", of + "hinge_longitudinal");
    histories.add("stinger_hinge", of + "hinge_vertical");
    histories.add("stinger_angle", of + "draught");
    histories.add("stinger_hinge", of + "stop_moment");
  }
  for (const LineResult& line : statics.lines) {
    histories.add("ends", "line/" + line.name + "/first_tension");
    histories.add("ends", "line/" + line.name + "/second_tension");
  }
  Json all = histories.take();
  for (Json& history : mooring_history_data(results)) all.push_back(std::move(history));
  if (statics.moorings && statics.moorings->operation == "pull_ahead") {
    for (Json& history : operation_history_data(results)) all.push_back(std::move(history));
  }
  return all;
}

Json spectrum_data(const DynamicResults& results) {
  constexpr double kShare = 0.995;
  constexpr std::size_t kMaxSpectrumPoints = 400;
  Json all = Json::array();
  for (const Spectrum& spectrum : results.spectra) {
    const std::size_t count = std::min(spectrum.frequency.size(), spectrum.density.size());
    double total = 0.0;
    for (std::size_t i = 0; i < count; ++i) {
      total += spectrum.density[i];
    }
    const Quantity q = quantity(spectrum.name, spectrum.units);
    if (!(total > 0.0) || !std::isfinite(total) || !varies_visibly(spectrum, total, q)) {
      continue;
    }
    Json frequency = Json::array(), density = Json::array();
    double part = 0.0;
    std::size_t last = 0;
    while (last < count && part < kShare * total) {
      part += spectrum.density[last++];
    }
    const std::size_t stride = (last + kMaxSpectrumPoints - 1) / kMaxSpectrumPoints;
    for (std::size_t i = 0; i < last; i += stride) {
      const auto first = spectrum.density.begin() + static_cast<std::ptrdiff_t>(i);
      const auto peak = std::max_element(first, first + static_cast<std::ptrdiff_t>(std::min(stride, last - i)));
      frequency.push_back(json_number(spectrum.frequency[static_cast<std::size_t>(peak - spectrum.density.begin())]));
      density.push_back(json_number(q.factor * q.factor * *peak));
    }
    all.push_back({{"title", spectrum_title(spectrum.name, q)},
                   {"unit", q.unit},
                   {"frequency", frequency},
                   {"density", density}});
  }
  return all;
}

}  // namespace overbend
