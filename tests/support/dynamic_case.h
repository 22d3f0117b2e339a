/// Results of a dynamic analysis with a value of its own in each member, and a run that belongs to them. They are no
/// physics: they show what is mixed up or lost on its way through files.
#pragma once

#include <cmath>
#include <filesystem>
#include <optional>

#include "results/fields/check_fields.h"
#include "results/fields/dynamic_scalars.h"
#include "results/fields/stinger_dynamics_fields.h"
#include "runstore/dynamic_histories.h"
#include "runstore/run_store.h"

namespace overbend::testing {

/// Gives every visited member another value.
struct FillVisitor {
  int next = 0;
  void operator()(const ResultField&, double& value) { value = std::sqrt(2.0 + ++next); }
  void operator()(const ResultField&, std::optional<double>& value) { value = std::sqrt(2.0 + ++next); }
  void operator()(const ResultField&, int& value) { value = ++next; }
  void operator()(const ResultField&, std::int64_t& value) { value = (std::int64_t{1} << 40) + ++next; }
  void operator()(const ResultField&, std::uint64_t& value) {
    value = ~std::uint64_t{0} - static_cast<unsigned>(++next);
  }
  void operator()(const ResultField&, bool& value) { value = (++next % 2) == 0; }
  void operator()(const ResultField& field, std::string& value) { value = field.name + " " + std::to_string(++next); }
  void operator()(const ResultField& field, Assumption& value) {
    value = {static_cast<AssumptionRank>(++next % 3), field.name + " " + std::to_string(next)};
  }
  void operator()(const ResultField& field, Finding& value) {
    const double number = std::sqrt(2.0 + ++next);
    value = Finding{FindingCode::free_spans, field.name + " " + std::to_string(next)}.on("pipe").at_time(number);
    value.numbers = {{"length", number, "m"}};
  }
  void operator()(const ResultField&, RollerPosition& value) { value = RollerPosition::starboard; }
  template <int Rows>
  void operator()(const ResultField& field, Eigen::Matrix<double, Rows, 1>& value) {
    for (double& number : value) (*this)(field, number);
  }
  template <class Value>
  void operator()(const ResultField& field, std::vector<Value>& values) {
    if (values.empty()) values.resize(3);
    for (Value& value : values) (*this)(field, value);
  }
};

inline void fill_region(DynamicRegion& region, FillVisitor& fill) {
  visit_dynamic_region(
      region, [&](const ResultField& field, DynamicExtreme& extreme) { visit_dynamic_extreme(field, extreme, fill); });
}

/// A support and a roller for each of statics.
inline void fill_supports(DynamicResults& results, const StaticResults& statics, FillVisitor& fill) {
  int number = 0;
  for (const SupportResult& support : statics.supports) {
    SupportDynamics& s = results.supports.emplace_back();
    visit_dynamic_support(s, fill);
    s.name = support.name;
    for (std::size_t row = 0; row < support.rows.size(); ++row) {
      for (const RollerResult& roller : support.rows[row].rollers) {
        RollerDynamics& r = s.rollers.emplace_back();
        visit_dynamic_roller(r, fill);
        r.roller = number++;
        r.box = static_cast<int>(results.supports.size()) - 1;
        r.row = static_cast<int>(row);
        r.position = roller.position;
      }
    }
  }
}

inline void fill_stations(DynamicResults& results, const StaticResults& statics, FillVisitor& fill) {
  constexpr std::size_t kCount = 40;
  results.station_s.resize(kCount);
  visit_dynamic_stations(results, fill);
  const auto spread = [&](Envelope& e) {
    for (std::vector<double>* list : {&e.min, &e.max, &e.mean, &e.std}) {
      list->resize(kCount);
      fill(ResultField{}, *list);
    }
  };
  for (Envelope* e : {&results.effective_tension, &results.bending_moment, &results.bending_stress, &results.von_mises,
                      &results.strain, &results.x, &results.y, &results.z}) {
    spread(*e);
  }
  for (std::vector<double>* list : {&results.static_tension, &results.static_moment, &results.static_bending_stress,
                                    &results.static_von_mises, &results.static_strain}) {
    list->resize(kCount);
    fill(ResultField{}, *list);
  }
  const auto fill_list = [&](const ResultField&, std::vector<double>& list) {
    list.resize(kCount);
    fill(ResultField{}, list);
  };
  visit_station_design(results.design, fill_list);
  results.static_place.resize(kCount);
  fill(ResultField{}, results.static_place);
  for (std::size_t i = 0; i < kCount; ++i) {
    results.station_s[i] = statics.total_length * static_cast<double>(i) / (kCount - 1);
  }
}

/// Everything but the histories, which belong to the run.
inline DynamicResults filled_dynamics(const StaticResults& statics) {
  DynamicResults results;
  FillVisitor fill;
  visit_dynamic_keys(results, fill, statics.stinger_tip_clearance.has_value());
  visit_energy(results.energy, fill);
  visit_tensioner(results.tensioner, fill);
  visit_dynamic_run(results.run, fill);
  if (statics.overbend) fill_region(results.overbend, fill);
  fill_region(results.sagbend, fill);
  if (statics.tower) fill_region(results.tower, fill);
  visit_dynamic_extreme(min_effective_tension_field(), results.min_effective_tension, fill);
  fill_stations(results, statics, fill);
  fill_supports(results, statics, fill);
  results.hardest_impacts.resize(statics.supports.empty() ? 0 : 5);
  for (Impact& impact : results.hardest_impacts) visit_impact(impact, fill);
  results.stinger.resize(2);
  for (StingerSectionDynamics& section : results.stinger) visit_stinger_dynamics(section, fill);
  results.extremes.resize(2);
  for (ExtremeEstimate& estimate : results.extremes) visit_estimate(estimate, fill);
  results.spectra = {{"top_tension", "N", {0.0, 0.1}, {3.0, 1.0 / 3.0}}, {"support/b 8/reaction", "N", {0.2}, {7.0}}};
  return results;
}

inline const std::vector<HistoryColumn>& stored_columns() {
  static const std::vector<HistoryColumn> columns = {{"time", "s", "Time", false, false},
                                                     {"top_tension", "N", "Tension at the tensioner", true, true},
                                                     {"heave", "m", "Heave of the vessel", false, true},
                                                     {"support/b 8/reaction", "N", "Reaction", true, false},
                                                     {"support/b 8/separation", "m", "Separation", false, false}};
  return columns;
}

/// Row `i` of column `c` holds sin(c i); snapshot `i` of 37, of 40 stations, holds 1000 i + k at its place k; impact
/// `i` of 20,000 hits roller i mod 7 at i / 8.
inline RunStore filled_run(const std::filesystem::path& folder, int rows = 50'000) {
  RunStore store = RunStore::create(folder, "title: x\n", 7);
  store.begin(stored_columns(), {40, 0});
  std::vector<double> values(stored_columns().size());
  for (int i = 0; i < rows; ++i) {
    values[0] = 0.25 * (i - 40);
    for (std::size_t c = 1; c < values.size(); ++c) values[c] = std::sin(static_cast<double>(c) * i);
    store.row(values);
  }
  std::vector<double> numbers(5 * 40 + 12);
  for (int i = 0; i < 37; ++i) {
    for (std::size_t k = 0; k < numbers.size(); ++k) numbers[k] = 1000.0 * i + static_cast<double>(k);
    store.snapshot(i, numbers);
  }
  for (int i = 0; i < 20'000; ++i) store.impact({i % 7, 0.125 * i, 0.1, 1e5 + i, 0.02, 900.0, 1e-4, 2e6});
  return store;
}

}  // namespace overbend::testing
