#include "io/finite_check.h"

#include <cmath>
#include <optional>
#include <stdexcept>
#include <string>

#include "io/static_columns.h"
#include "io/static_scalars.h"

namespace overbend {
namespace {

/// Visits fields, `place` before their names.
struct FiniteVisitor {
  std::string place;

  void operator()(const Field& field, double value) const {
    if (!std::isfinite(value)) {
      throw std::runtime_error(place + field.name + " is not a finite number; nothing is written");
    }
  }
  void operator()(const Field& field, const std::optional<double>& value) const {
    if (value) (*this)(field, *value);
  }
  void operator()(const Field& field, const Vec3& value) const {
    for (int i = 0; i < 3; ++i) (*this)(Field{component_name(field, i)}, value(i));
  }
  void operator()(const Field& field, const Mat3& value) const {
    for (int i = 0; i < 9; ++i) (*this)(field, value(i / 3, i % 3));
  }
  template <class Other>
  void operator()(const Field&, const Other&) const {}  // text, flags and counts are always finite
};

void check_region(const std::string& name, const RegionResult& region) {
  visit_region(region, [&](const char* quantity, const char* units, const char* description, const Extreme& extreme) {
    FiniteVisitor visit{name + "." + quantity + "."};
    visit_extreme_fields(units, description, extreme, visit);
  });
}

std::string indexed(const std::string& name, std::size_t index) {
  return name + "[" + std::to_string(index) + "].";
}

void check_support(const SupportResult& support, const std::string& place) {
  FiniteVisitor visit{place};
  visit_support(support, visit);
  for (std::size_t i = 0; i < support.rows.size(); ++i) {
    const std::string row_place = place + indexed("rows", i);
    visit.place = row_place;
    visit_row(support.rows[i], visit);
    for (std::size_t j = 0; j < support.rows[i].rollers.size(); ++j) {
      visit.place = row_place + indexed("rollers", j);
      visit_roller(support.rows[i].rollers[j], visit);
    }
  }
}

}  // namespace

void require_finite(const StaticResults& results) {
  FiniteVisitor visit;
  visit_key_results(results, visit);
  visit_scene(results, visit);
  visit.place = "touchdown.";
  visit_touchdown(results.touchdown, visit);
  visit.place = "sums.";
  visit_sums(results, visit);
  visit.place = "solve.";
  visit_solve(results.solve, visit);
  if (results.overbend) check_region("overbend", *results.overbend);
  check_region("sagbend", results.sagbend);
  for (std::size_t i = 0; i < results.sections.size(); ++i) {
    visit.place = indexed("sections", i);
    visit_section(results.sections[i], visit);
  }
  for (std::size_t i = 0; i < results.stations.size(); ++i) {
    visit.place = indexed("stations", i);
    visit_station(results.stations[i], visit);
  }
  for (std::size_t i = 0; i < results.supports.size(); ++i) {
    check_support(results.supports[i], indexed("supports", i));
  }
}

}  // namespace overbend
