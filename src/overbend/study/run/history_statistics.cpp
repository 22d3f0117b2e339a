#include "study/run/history_statistics.h"

#include <algorithm>
#include <string_view>

#include "base/constants.h"
#include "base/interruption.h"
#include "numerics/extremes.h"
#include "numerics/welch.h"
#include "runstore/dynamic_histories.h"
#include "study/run/non_stationary.h"
#include "study/run/run_findings.h"

namespace overbend {
namespace {

/// Returns the values from t = 0 on.
std::span<const double> after_build_up(const std::vector<double>& time, const std::vector<double>& values) {
  const auto first = std::lower_bound(time.begin(), time.end(), 0.0) - time.begin();
  return std::span<const double>(values).subspan(static_cast<std::size_t>(first));
}

/// Returns a column by its name; empty if there is none.
std::vector<double> find_table_column(const RunStore& store, std::string_view name) {
  for (std::size_t i = 1; i < store.columns().size(); ++i) {
    if (store.columns()[i].name == name) return store.column(i);
  }
  return {};
}

std::string method_label(ExtremeMethod method) {
  switch (method) {
    case ExtremeMethod::none:
      return "";
    case ExtremeMethod::regular:
      return "equal peaks";
    case ExtremeMethod::weibull:
      return "Weibull";
    case ExtremeMethod::pareto:
      return "generalised Pareto";
    case ExtremeMethod::observed:
      return "observed peaks";
  }
  return "";
}

std::string quality_label(ExtremeQuality quality) {
  return quality == ExtremeQuality::good ? "good" : quality == ExtremeQuality::uncertain ? "uncertain" : "none";
}

std::string doubt_message(ExtremeDoubt doubt) {
  switch (doubt) {
    case ExtremeDoubt::none:
      return "";
    case ExtremeDoubt::few_peaks:
      return "fewer than 30 peaks";
    case ExtremeDoubt::rare:
      return "the quantity is constant between rare peaks, and the largest do not follow the distribution of the "
             "others: run three hours or more, or several seeds";
    case ExtremeDoubt::no_tail:
      return "no distribution describes the largest peaks: run longer";
    case ExtremeDoubt::wide:
      return "few peaks for three hours: run longer";
  }
  return "";
}

void put(const ConfidentEstimate& from, std::optional<double>& value, std::optional<double>& low,
         std::optional<double>& high) {
  value = from.value;
  low = from.low;
  high = from.high;
}

ExtremeEstimate estimate(const HistoryColumn& column, const ExtremeFit& fit) {
  ExtremeEstimate out;
  out.name = column.name;
  out.units = column.units;
  out.is_minimum = column.is_minimum;
  out.peaks = fit.peaks;
  out.observed = fit.observed;
  out.enough = fit.enough;
  out.method = method_label(fit.method);
  out.quality = quality_label(fit.quality);
  out.remark = doubt_message(fit.doubt);
  if (fit.quality != ExtremeQuality::none) {
    put(fit.estimate, out.estimate, out.low, out.high);
  }
  put(fit.gumbel, out.gumbel, out.gumbel_low, out.gumbel_high);
  put(fit.weibull, out.weibull, out.weibull_low, out.weibull_high);
  if (fit.pareto && fit.quality != ExtremeQuality::none) put(*fit.pareto, out.pareto, out.pareto_low, out.pareto_high);
  return out;
}

/// Returns the observed values only, for a record that is not stationary.
ExtremeEstimate without_estimate(const HistoryColumn& column, const ExtremeFit& fit, const std::string& why) {
  ExtremeFit none = fit;
  none.quality = ExtremeQuality::none;
  none.method = ExtremeMethod::none;
  ExtremeEstimate out = estimate(column, none);
  for (std::optional<double>* value :
       {&out.weibull, &out.weibull_low, &out.weibull_high, &out.gumbel, &out.gumbel_low, &out.gumbel_high}) {
    value->reset();
  }
  out.remark = "the record is not stationary: " + why;
  return out;
}

}  // namespace

void finish_histories(const Description& description, DynamicResults& results, const RunStore& store) {
  results.histories = summarise_histories(store);
  const std::vector<double> time = store.column(0);
  results.non_stationary = non_stationary(description, results);
  const auto keep = [&](const HistoryColumn& column, const ExtremeFit& fit) {
    const std::string& why = results.non_stationary;
    results.extremes.push_back(why.empty() ? estimate(column, fit) : without_estimate(column, fit, why));
  };
  for (std::size_t i = 1; i < store.columns().size(); ++i) {
    check_interruption();
    const HistoryColumn& column = store.columns()[i];
    if (!column.extreme && !column.is_minimum && !column.spectrum) {
      continue;
    }
    const std::vector<double> values = store.column(i);
    const std::span<const double> counted = after_build_up(time, values);
    const auto [min, max] = std::minmax_element(counted.begin(), counted.end());
    if (counted.empty() || *min == *max) {  // a constant column has neither a spectrum nor extremes
      continue;
    }
    if (column.spectrum) {
      const PowerSpectrum spectrum = power_spectrum(counted, results.output_step);
      results.spectra.push_back({column.name, column.units, spectrum.frequency, spectrum.density});
    }
    if (column.extreme) {
      keep(column, fit_extremes(counted, results.output_step, kThreeHours));
    }
    if (column.is_minimum) {
      keep(column, fit_minimum(counted, results.output_step, kThreeHours));
    }
  }
  const std::vector<double> tension = find_table_column(store, "tensioner/tension");
  const std::vector<double> travel = find_table_column(store, "tensioner/travel");
  warn_of_run(description, results, tension.empty() ? std::span<const double>() : after_build_up(time, tension));
  warn_of_sea(description, results);
  if (!travel.empty()) warn_of_tensioner_uncertainty(description, after_build_up(time, travel), results);
  warn_of_large_motion(description.vessel, results);
  accept(results.findings, description.checks.accepted_findings);
}

}  // namespace overbend
