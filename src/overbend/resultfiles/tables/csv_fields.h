/// Headings and rows of text tables, from the fields with a heading; see results/fields/result_field.h.
#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <type_traits>

#include "resultfiles/tables/csv_table.h"
#include "results/dynamic_results.h"
#include "results/fields/result_field.h"

namespace overbend {

/// "bending moment [kN m]"
inline std::string headed(std::string_view heading, std::string_view unit) {
  return unit.empty() ? std::string(heading) : std::string(heading).append(" [").append(unit).append("]");
}

/// Collects the headings of the visited fields. Rows are examples only: their values are ignored.
struct CsvHead {
  std::vector<std::string> names;

  template <class Value>
  void operator()(const ResultField& f, const Value&) {
    if (f.heading.empty()) return;
    const std::string_view unit = std::is_same_v<Value, double> ? shown_unit(f).name : "";
    names.push_back(headed(f.heading, unit));
  }
  void operator()(const ResultField& f, const Vec3&) {
    if (f.heading != kComponents) return;
    for (int axis = 0; axis < 3; ++axis) {
      names.push_back(headed(std::string_view("xyz").substr(axis, 1), shown_unit(f).name));
    }
  }
  void operator()(const ResultField& f, const std::optional<double>&) { (*this)(f, 0.0); }
  template <class SpreadType>
  void spread(const ResultField& f, const SpreadType&) {
    if (f.heading.empty()) return;
    for (const char* part : {" min", " max", " mean", " std"}) {
      names.push_back(headed(std::string(f.heading) + part, shown_unit(f).name));
    }
  }
};

/// Writes the cells of one row, in the units of the headings.
struct CsvCells {
  CsvTable& table;

  void operator()(const ResultField& f, double value) {
    if (f.heading.empty()) return;
    const bool absent = f.from_anchor && value < 0.0;  // the pipe does not pass this point
    table.cell(absent ? std::numeric_limits<double>::quiet_NaN() : value * shown_unit(f).factor);
  }
  void operator()(const ResultField& f, const std::optional<double>& value) {
    (*this)(f, value.value_or(std::numeric_limits<double>::quiet_NaN()));
  }
  void operator()(const ResultField& f, std::int64_t value) { text(f, std::to_string(value)); }
  void operator()(const ResultField& f, int value) { text(f, std::to_string(value)); }
  void operator()(const ResultField& f, const std::string& value) { text(f, value); }
  template <HasResultEnumNames Enum>
  void operator()(const ResultField& f, const Enum& value) {
    text(f, word(value));
  }
  void operator()(const ResultField& f, const Vec3& value) {
    if (f.heading != kComponents) return;
    for (int axis = 0; axis < 3; ++axis) table.cell(value(axis) * shown_unit(f).factor);
  }
  template <class Other>
  void operator()(const ResultField&, const Other&) {}  // flags and lists have no heading
  void spread(const ResultField& f, const SummaryStatistics& s) {
    if (f.heading.empty()) return;
    for (const double value : {s.min, s.max, s.mean, s.std}) table.cell(value * shown_unit(f).factor);
  }

 private:
  void text(const ResultField& f, const std::string& value) {
    if (!f.heading.empty()) table.cell(value);
  }
};

}  // namespace overbend
