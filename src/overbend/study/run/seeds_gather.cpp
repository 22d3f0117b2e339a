#include "study/run/seeds_gather.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

#include "base/constants.h"
#include "base/ranges.h"
#include "numerics/log_weibull.h"
#include "study/run/non_stationary.h"

namespace overbend {
namespace {

/// A gathered quantity and the function that evaluates it.
struct Rule {
  SeedQuantity quantity;
  std::function<double(const DynamicResults&)> value;
};

double max_reaction(const DynamicResults& r) {
  double max_reaction = 0.0;
  for (const SupportDynamics& support : r.supports) max_reaction = std::max(max_reaction, support.reaction.max);
  return max_reaction;
}

double compute_max_mooring_tension(const DynamicResults& r) {
  double max_tension = 0.0;
  for (const MooringLineDynamics& line : r.moorings) {
    max_tension = std::max(max_tension, line.fairlead_tension.whole.max);
  }
  return max_tension;
}

/// Over the lines that have not parted.
double compute_min_mooring_tension(const DynamicResults& r) {
  double min_tension = compute_max_mooring_tension(r);
  for (const MooringLineDynamics& line : r.moorings) {
    if (!line.parted_at) min_tension = std::min(min_tension, line.fairlead_tension.whole.min);
  }
  return min_tension;
}

double compute_max_mooring_utilisation(const DynamicResults& r) {
  double max_utilisation = 0.0;
  for (const MooringLineDynamics& line : r.moorings) {
    max_utilisation = std::max(max_utilisation, line.utilisation.value_or(0.0));
  }
  return max_utilisation;
}

double worst_utilisation(const DynamicResults& r) {
  const CheckRow* worst = find_governing_check(r.checks);
  return worst == nullptr ? 0.0 : worst->utilisation;
}

/// Damage of the worst spot. Its mean over the seeds is that of the sea state; the maximum is chance.
double max_passage_damage(const DynamicResults& r) {
  double max_damage = 0.0;
  if (!r.fatigue) return max_damage;
  for (const FatigueSpot& spot : r.fatigue->spots) max_damage = std::max(max_damage, spot.path_damage);
  return max_damage;
}

using Rules = std::vector<Rule>;

void add(Rules& list, SeedQuantity quantity, std::function<double(const DynamicResults&)> value) {
  list.push_back({std::move(quantity), std::move(value)});
}

constexpr SeedExtreme kMaximum = SeedExtreme::maximum, kMinimum = SeedExtreme::minimum, kNone = SeedExtreme::none;

void add_pipe(Rules& list, const StaticResults& statics) {
  using Results = DynamicResults;
  add(list, {"top_tension_max", "N", "Largest effective tension at the tensioner", kMaximum},
      [](const Results& r) { return r.top_tension.max; });
  add(list, {"top_tension_min", "N", "Smallest effective tension at the tensioner", kMinimum},
      [](const Results& r) { return r.top_tension.min; });
  if (statics.overbend) {
    add(list, {"overbend_max_bending_moment", "N m", "Largest bending moment of the overbend", kMaximum},
        [](const Results& r) { return r.overbend.bending_moment.over_time.max; });
    add(list, {"overbend_max_von_mises", "Pa", "Largest von Mises stress of the overbend", kMaximum},
        [](const Results& r) { return r.overbend.von_mises.over_time.max; });
    add(list, {"overbend_max_strain", "1", "Largest strain of the overbend", kMaximum},
        [](const Results& r) { return r.overbend.strain.over_time.max; });
  }
  add(list, {"sagbend_max_bending_moment", "N m", "Largest bending moment of the sagbend", kMaximum},
      [](const Results& r) { return r.sagbend.bending_moment.over_time.max; });
  add(list, {"sagbend_max_von_mises", "Pa", "Largest von Mises stress of the sagbend", kMaximum},
      [](const Results& r) { return r.sagbend.von_mises.over_time.max; });
  add(list, {"sagbend_max_strain", "1", "Largest strain of the sagbend", kMaximum},
      [](const Results& r) { return r.sagbend.strain.over_time.max; });
  if (statics.stinger_tip_clearance) {
    add(list, {"stinger_tip_clearance_min", "m", "Smallest separation at the last row of the stinger", kMinimum},
        [](const Results& r) { return r.stinger_tip_clearance.min; });
  }
  if (!statics.supports.empty()) {
    add(list, {"largest_reaction", "N", "Largest reaction of a support", kMaximum}, max_reaction);
    add(list, {"impact_count", "1", "Number of impacts", kNone},
        [](const Results& r) { return static_cast<double>(r.impact_count); });
  }
}

void add_vessel(Rules& list) {
  using Results = DynamicResults;
  add(list, {"largest_offset", "m", "Largest horizontal offset of the vessel from its initial position", kMaximum},
      [](const Results& r) { return r.vessel ? r.vessel->offset.whole.max : 0.0; });
  add(list, {"mean_surge", "m", "Mean surge of the vessel", kNone},
      [](const Results& r) { return r.vessel ? r.vessel->surge.whole.mean : 0.0; });
  add(list, {"mean_sway", "m", "Mean sway of the vessel", kNone},
      [](const Results& r) { return r.vessel ? r.vessel->sway.whole.mean : 0.0; });
  add(list, {"slow_surge_std", "m", "Standard deviation of the slow surge", kNone},
      [](const Results& r) { return r.vessel ? r.vessel->surge.slow.std : 0.0; });
  add(list, {"slow_sway_std", "m", "Standard deviation of the slow sway", kNone},
      [](const Results& r) { return r.vessel ? r.vessel->sway.slow.std : 0.0; });
}

void add_moorings(Rules& list) {
  add(list, {"largest_mooring_tension", "N", "Largest tension of a mooring line", kMaximum},
      compute_max_mooring_tension);
  add(list, {"smallest_mooring_tension", "N", "Smallest tension of a mooring line", kMinimum},
      compute_min_mooring_tension);
  add(list, {"largest_mooring_utilisation", "1", "Largest tension of a mooring line over its breaking load", kMaximum},
      compute_max_mooring_utilisation);
}

/// Quantities of line number `i` of a model of lines only.
void add_line(Rules& list, const std::string& name, std::size_t i) {
  const auto put = [&](const char* what, const char* meaning, SeedExtreme extreme, auto value) {
    add(list, {name + "/" + what, "N", meaning + (" of line " + name), extreme},
        [i, value](const DynamicResults& r) { return value(r.lines.at(i)); });
  };
  using Line = LineDynamics;
  put("first_tension_max", "Largest tension at the first end", kMaximum,
      [](const Line& line) { return line.first_tension.max; });
  put("first_tension_min", "Smallest tension at the first end", kMinimum,
      [](const Line& line) { return line.first_tension.min; });
  put("second_tension_max", "Largest tension at the second end", kMaximum,
      [](const Line& line) { return line.second_tension.max; });
  put("second_tension_min", "Smallest tension at the second end", kMinimum,
      [](const Line& line) { return line.second_tension.min; });
  put("least_tension", "Smallest tension along the line", kMinimum, [](const Line& line) { return line.min_tension; });
}

Rules rules(const StaticResults& statics, bool fatigue) {
  Rules list;
  if (statics.has_pipe()) add_pipe(list, statics);
  if (statics.moorings || statics.hull) add_vessel(list);
  if (statics.moorings) add_moorings(list);
  for (std::size_t i = 0; i < statics.lines.size(); ++i) add_line(list, statics.lines[i].name, i);
  if (statics.has_pipe()) {
    add(list, {"worst_check_utilisation", "1", "Largest utilisation of a governing code check", kMaximum},
        worst_utilisation);
  }
  if (fatigue) {
    add(list,
        {"fatigue_path_damage", "1", "Fatigue damage of a weld during its passage, worst spot; use the mean", kNone},
        max_passage_damage);
  }
  add(list, {"energy_drift", "1", "Error of the energy balance relative to the energy exchanged", kNone},
      [](const DynamicResults& r) { return r.energy.drift(); });
  return list;
}

void fit(SeedStatistics& statistics, std::span<const double> values, bool is_maximum, double duration) {
  std::vector<double> turned;  // for maxima the negatives, which have the distribution that fit_log_weibull fits
  for (const double value : values) turned.push_back(is_maximum ? -value : value);
  std::sort(turned.begin(), turned.end());
  const std::optional<LogWeibull> found = values.size() < kMinRuns ? std::nullopt : fit_log_weibull(turned, 0);
  statistics.enough = found.has_value();
  if (!found) return;
  const ConfidentEstimate minimum = confident(*found, turned.size(), 0, -std::log(kThreeHours / duration));
  const double sign = is_maximum ? -1.0 : 1.0;
  statistics.mode = sign * found->location;
  statistics.scale = found->scale;
  statistics.estimate = sign * minimum.value;
  statistics.low = is_maximum ? -minimum.high : minimum.low;
  statistics.high = is_maximum ? -minimum.low : minimum.high;
}

}  // namespace

std::vector<SeedQuantity> seed_quantities(const StaticResults& statics, bool fatigue) {
  std::vector<SeedQuantity> quantities;
  for (const Rule& rule : rules(statics, fatigue)) quantities.push_back(rule.quantity);
  return quantities;
}

std::vector<double> seed_values(const StaticResults& statics, const DynamicResults& results, bool fatigue) {
  std::vector<double> values;
  for (const Rule& rule : rules(statics, fatigue)) values.push_back(rule.value(results));
  return values;
}

SeedStatistics seed_statistics(std::span<const double> values, SeedExtreme extreme, double duration) {
  SeedStatistics s;
  const double count = static_cast<double>(values.size());
  const auto [min, max] = std::minmax_element(values.begin(), values.end());
  s.min = *min;
  s.max = *max;
  for (const double value : values) s.mean += value / count;
  double squares = 0.0;
  for (const double value : values) squares += (value - s.mean) * (value - s.mean);
  s.std = values.size() > 1 ? std::sqrt(squares / (count - 1.0)) : 0.0;
  if (extreme != SeedExtreme::none) fit(s, values, extreme == SeedExtreme::maximum, duration);
  return s;
}

bool never_negative(const std::string& quantity) {
  return quantity == "smallest_mooring_tension";
}

namespace {

bool has_non_stationary_run(const SeedsResults& results) {
  return ranges::any_of(results.runs,
                        [](const SeedRun& run) { return has_code(run.findings, FindingCode::record_not_stationary); });
}

void limit_to_positive(SeedStatistics& s) {
  for (double* value : {&s.estimate, &s.low, &s.high}) *value = std::max(*value, 0.0);
  if (!s.acer) return;
  for (double* value : {&s.acer->estimate, &s.acer->low, &s.acer->high}) *value = std::max(*value, 0.0);
}

}  // namespace

void fill_statistics(SeedsResults& results) {
  results.statistics.clear();
  if (results.runs.empty()) return;
  std::vector<double> values;
  for (std::size_t i = 0; i < results.quantities.size(); ++i) {
    values.clear();
    for (const SeedRun& run : results.runs) {
      if (!std::isnan(run.values.at(i))) values.push_back(run.values[i]);  // missing values are ignored
    }
    if (values.empty()) values.push_back(results.runs.front().values.at(i));
    const SeedExtreme extreme = has_non_stationary_run(results) ? SeedExtreme::none : results.quantities[i].extreme;
    results.statistics.push_back(seed_statistics(values, extreme, results.duration));
    if (never_negative(results.quantities[i].name)) limit_to_positive(results.statistics.back());
  }
}

void add_acer(SeedsResults& results, std::span<const std::vector<HistoryPeaks>> peaks) {
  if (has_non_stationary_run(results)) return;
  for (std::size_t i = 0; i < results.statistics.size(); ++i) {
    if (results.quantities.at(i).extreme == SeedExtreme::none) continue;
    const std::optional<AcerFit> fit = fit_result_acer(peaks, results.quantities[i].name);
    if (!fit) continue;
    results.statistics[i].acer =
        SeedAcer{fit->estimate.value, fit->estimate.low, fit->estimate.high, fit->order, fit->peaks};
    if (never_negative(results.quantities[i].name)) limit_to_positive(results.statistics[i]);
  }
}

}  // namespace overbend
