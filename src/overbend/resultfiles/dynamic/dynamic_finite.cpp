#include "resultfiles/lines/bodies_files.h"
#include "resultfiles/lines/lines_files.h"
#include "resultfiles/static/finite_check.h"
#include "resultfiles/tables/finite_visitor.h"
#include "results/fields/check_fields.h"
#include "results/fields/dynamic_scalars.h"
#include "results/fields/fatigue_fields.h"
#include "results/fields/moored_fields.h"
#include "results/fields/stinger_dynamics_fields.h"

namespace overbend {
namespace {

bool is_absent(double value) {
  return std::isnan(value);
}
template <class Other>
bool is_absent(const Other&) {
  return false;
}

/// Lists, each value by its index.
struct FiniteLists {
  std::string place;
  bool gaps = false;  ///< True if values may be missing.
  template <class Value>
  void operator()(const ResultField& field, const std::vector<Value>& values) const {
    for (std::size_t i = 0; i < values.size(); ++i) {
      if (gaps && is_absent(values[i])) continue;
      FiniteVisitor{place + "[" + std::to_string(i) + "]."}(field, values[i]);
    }
  }
};

template <class Rows, class Function>
void check_rows(const std::string& name, const Rows& rows, Function visit_row) {
  for (std::size_t i = 0; i < rows.size(); ++i) {
    FiniteVisitor visit{indexed(name, i)};
    visit_row(rows[i], visit);
  }
}

void check_region(const std::string& name, const DynamicRegion& region) {
  visit_dynamic_region(region, [&](const ResultField& field, const DynamicExtreme& extreme) {
    FiniteVisitor visit{"dynamic." + name + "." + field.name + "."};
    visit_dynamic_extreme(field, extreme, visit);
  });
}

void check_fatigue(const DynamicResults& results) {
  if (!results.fatigue) return;
  FiniteVisitor visit{"dynamic.fatigue."};
  visit_fatigue(*results.fatigue, visit);
  check_rows("dynamic.fatigue.spots", results.fatigue->spots,
             [](const auto& row, auto& v) { visit_fatigue_spot(row, v); });
  for (const FatigueSpot& spot : results.fatigue->spots) {
    const FiniteLists along{"dynamic.fatigue.along"};
    visit_fatigue_along(spot, along);
  }
}

void check_histories(const DynamicResults& results) {
  for (const HistorySummary& history : results.histories) {
    const bool gaps = may_be_missing(history.name);
    FiniteVisitor visit{"dynamic.histories." + history.name + "."};
    if (!gaps || !std::isnan(history.over_time.mean)) visit_spread(ResultField{}, history.over_time, visit);
    const FiniteLists lists{"dynamic.histories." + history.name, gaps};
    lists(ResultField{"low"}, history.low);
    lists(ResultField{"high"}, history.high);
  }
  for (const Spectrum& spectrum : results.spectra) {
    const FiniteLists lists{"dynamic.spectra." + spectrum.name};
    lists(ResultField{"frequency"}, spectrum.frequency);
    lists(ResultField{"density"}, spectrum.density);
  }
}

}  // namespace

void require_finite(const DynamicResults& results) {
  FiniteVisitor visit{"dynamic."};
  visit_dynamic_keys(results, visit, true);
  visit.place = "dynamic.energy.";
  visit_energy(results.energy, visit);
  visit.place = "dynamic.tensioner.";
  visit_tensioner(results.tensioner, visit);
  visit.place = "dynamic.run.";
  visit_dynamic_run(results.run, visit);
  visit.place = "dynamic.smallest_tension.";
  visit_dynamic_extreme(min_effective_tension_field(), results.min_effective_tension, visit);
  check_region("overbend", results.overbend);
  check_region("tower", results.tower);
  check_region("sagbend", results.sagbend);
  const FiniteLists stations{"dynamic.stations"};
  visit_dynamic_stations(results, stations);
  check_rows("dynamic.supports", results.supports, [](const auto& row, auto& v) { visit_dynamic_support(row, v); });
  for (std::size_t i = 0; i < results.supports.size(); ++i) {
    check_rows(indexed("dynamic.supports", i) + "rollers", results.supports[i].rollers,
               [](const auto& row, auto& v) { visit_dynamic_roller(row, v); });
  }
  check_rows("dynamic.hardest_impacts", results.hardest_impacts,
             [](const auto& row, auto& v) { visit_impact(row, v); });
  check_rows("dynamic.extremes", results.extremes, [](const auto& row, auto& v) { visit_estimate(row, v); });
  if (results.vessel) {
    visit.place = "dynamic.vessel.";
    visit_vessel_dynamics(*results.vessel, visit);
  }
  check_rows("dynamic.thrust", results.thrust, [](const auto& row, auto& v) { visit_thrust_dynamics(row, v); });
  check_rows("dynamic.moorings", results.moorings, [](const auto& row, auto& v) { visit_mooring_dynamics(row, v); });
  check_rows("dynamic.stinger", results.stinger, [](const auto& row, auto& v) { visit_stinger_dynamics(row, v); });
  require_finite(results.lines);
  require_finite(results.bodies);
  check_fatigue(results);
  check_histories(results);
  const FiniteColumns design{"dynamic.design"};
  visit_station_design(results.design, design);
  require_finite(results.checks, "dynamic.checks.");
}

}  // namespace overbend
