#include "study/dynamic_finish.h"

#include <algorithm>
#include <string_view>

#include "base/constants.h"
#include "base/interruption.h"
#include "numerics/extremes.h"
#include "numerics/welch.h"
#include "runstore/dynamic_histories.h"
#include "study/run_warnings.h"

namespace overbend {
namespace {

/// Values from t = 0 on.
std::span<const double> after_build_up(const std::vector<double>& time, const std::vector<double>& values) {
  const auto first = std::lower_bound(time.begin(), time.end(), 0.0) - time.begin();
  return std::span<const double>(values).subspan(static_cast<std::size_t>(first));
}

/// Empty where there is no such column.
std::vector<double> column_of(const RunStore& store, std::string_view name) {
  for (std::size_t i = 1; i < store.columns().size(); ++i) {
    if (store.columns()[i].name == name) return store.column(i);
  }
  return {};
}

ExtremeEstimate estimate(const HistoryColumn& column, const ExtremeFit& fit) {
  ExtremeEstimate out;
  out.name = column.name;
  out.units = column.units;
  out.smallest = column.smallest;
  out.peaks = fit.peaks;
  out.observed = fit.observed;
  out.enough = fit.enough;
  out.weibull = fit.weibull.value;
  out.weibull_low = fit.weibull.low;
  out.weibull_high = fit.weibull.high;
  out.gumbel = fit.gumbel.value;
  out.gumbel_low = fit.gumbel.low;
  out.gumbel_high = fit.gumbel.high;
  return out;
}

}  // namespace

void finish_histories(const Description& description, DynamicResults& results, const RunStore& store) {
  results.histories = summarise_histories(store);
  const std::vector<double> time = store.column(0);
  for (std::size_t i = 1; i < store.columns().size(); ++i) {
    check_interruption();
    const HistoryColumn& column = store.columns()[i];
    if (!column.extreme && !column.smallest && !column.spectrum) {
      continue;
    }
    const std::vector<double> values = store.column(i);
    const std::span<const double> counted = after_build_up(time, values);
    const auto [least, largest] = std::minmax_element(counted.begin(), counted.end());
    if (counted.empty() || *least == *largest) {  // what never changes has neither
      continue;
    }
    if (column.spectrum) {
      const PowerSpectrum spectrum = power_spectrum(counted, results.output_step);
      results.spectra.push_back({column.name, column.units, spectrum.frequency, spectrum.density});
    }
    if (column.extreme) {
      results.extremes.push_back(estimate(column, fit_extremes(counted, results.output_step, kThreeHours)));
    }
    if (column.smallest) {
      results.extremes.push_back(estimate(column, fit_smallest(counted, results.output_step, kThreeHours)));
    }
  }
  const std::vector<double> tension = column_of(store, "tensioner/tension");
  const std::vector<double> travel = column_of(store, "tensioner/travel");
  warn_of_run(description.environment.waves, results,
              tension.empty() ? std::span<const double>() : after_build_up(time, tension));
  warn_of_sea(description, results);
  if (!travel.empty()) warn_of_tensioners_chance(description, after_build_up(time, travel), results);
  warn_of_large_motion(description.vessel, results);
}

}  // namespace overbend
