#include "resultfiles/static/finite_check.h"

#include "resultfiles/lines/bodies_files.h"
#include "resultfiles/lines/lines_files.h"
#include "resultfiles/moored/mooring_tables.h"
#include "resultfiles/tables/finite_visitor.h"
#include "results/fields/attachment_fields.h"
#include "results/fields/check_fields.h"
#include "results/fields/dragging_fields.h"
#include "results/fields/ground_fields.h"
#include "results/fields/lay_operation_fields.h"
#include "results/fields/static_scalars.h"
#include "results/fields/static_tables.h"
#include "results/fields/stinger_fields.h"

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
    for (const SheetLine& line : checks.rows[i].sheet) visit_sheet_line(line, visit);
  }
  const FiniteColumns columns{place + "along"};
  visit_check_along(checks.along, columns);
}

void check_bed(const BedResults& bed) {
  FiniteVisitor visit;
  visit.place = "bed.";
  visit_laid_pipe(bed, visit);
  for (std::size_t i = 0; i < bed.heights.size(); ++i) {
    visit.place = indexed("bed.heights", i);
    visit_bed_height(bed.heights[i], visit);
  }
  for (std::size_t i = 0; i < bed.contacts.size(); ++i) {
    visit.place = indexed("bed.contacts", i);
    visit_bed_contact(bed.contacts[i], visit);
  }
  for (std::size_t i = 0; i < bed.spans.size(); ++i) {
    visit.place = indexed("bed.spans", i);
    visit_free_span(bed.spans[i], visit);
  }
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
  visit_extreme_fields(min_effective_tension_field(), results.min_effective_tension, visit);
  if (results.overbend) check_region("overbend", *results.overbend);
  if (results.tower) check_region("tower", *results.tower);
  check_region("sagbend", results.sagbend);
  for (std::size_t i = 0; i < results.sections.size(); ++i) {
    visit.place = indexed("sections", i);
    visit_section(results.sections[i], visit);
  }
  for (std::size_t i = 0; i < results.structures.size(); ++i) {
    visit.place = indexed("structures", i);
    visit_structure(results.structures[i], visit);
  }
  for (std::size_t i = 0; i < results.points.size(); ++i) {
    visit.place = indexed("points", i);
    visit_pipe_point(results.points[i], visit);
  }
  for (std::size_t i = 0; i < results.wires.size(); ++i) {
    visit.place = indexed("wires", i);
    visit_pipe_wire(results.wires[i], visit);
  }
  for (std::size_t i = 0; i < results.stations.size(); ++i) {
    visit.place = indexed("stations", i);
    visit_station(results.stations[i], visit);
  }
  for (std::size_t i = 0; i < results.supports.size(); ++i) {
    check_support(results.supports[i], indexed("supports", i));
  }
  for (std::size_t i = 0; i < results.stinger.size(); ++i) {
    visit.place = indexed("stinger", i);
    visit_stinger_section(results.stinger[i], visit);
    for (const StingerTankResult& tank : results.stinger[i].tanks) visit_stinger_tank(tank, visit);
  }
  visit.place = "head.";
  if (results.head) visit_head(*results.head, visit);
  visit.place = "cable.";
  if (results.cable) visit_cable(*results.cable, visit);
  visit.place = "far_anchor.";
  if (results.far_anchor) visit_far_anchor(*results.far_anchor, visit);
  visit.place = "dragging.";
  if (results.dragging) visit_dragging(*results.dragging, visit);
  if (results.dragging && results.dragging->lift_off) visit_lift_off(*results.dragging->lift_off, visit);
  if (results.bed) check_bed(*results.bed);
  require_finite(results.checks, "checks.");
  if (results.moorings) require_finite(*results.moorings);
  if (results.hull) require_finite(*results.hull);
  require_finite(results.lines);
  require_finite(results.bodies);
}

}  // namespace overbend
