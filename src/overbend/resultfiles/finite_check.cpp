#include "resultfiles/finite_check.h"

#include "resultfiles/finite_visitor.h"
#include "resultfiles/mooring_writer.h"
#include "results/fields/check_fields.h"
#include "results/fields/static_tables.h"
#include "results/fields/static_values.h"

namespace overbend {
namespace {

void check_region(const std::string& name, const RegionResult& region) {
  visit_region(region, [&](const ResultField& field, const Extreme& extreme) {
    FiniteVisitor visit{name + "." + field.name + "."};
    visit_extreme_fields(field, extreme, visit);
  });
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

void require_finite(const CheckTable& checks, const std::string& place) {
  for (std::size_t i = 0; i < checks.rows.size(); ++i) {
    FiniteVisitor visit{place + indexed("list", i)};
    visit_check(checks.rows[i], visit);
    for (const CheckInput& input : checks.rows[i].inputs) visit_check_input(input, visit);
  }
  const FiniteColumns columns{place + "along"};
  visit_check_along(checks.along, columns);
}

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
  visit.place = "smallest_tension.";
  visit_extreme_fields(smallest_tension_field(), results.smallest_tension, visit);
  if (results.overbend) check_region("overbend", *results.overbend);
  if (results.tower) check_region("tower", *results.tower);
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
  require_finite(results.checks, "checks.");
  if (results.moorings) require_finite(*results.moorings);
  if (results.hull) require_finite(*results.hull);
}

}  // namespace overbend
