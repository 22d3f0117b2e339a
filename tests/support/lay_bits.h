/// All numbers of a lay as one text, by their bits.
#pragma once

#include <string>

#include "results/fields/ground_fields.h"
#include "results/fields/lay_operation_fields.h"
#include "results/fields/route_fields.h"
#include "results/fields/static_scalars.h"
#include "results/fields/static_tables.h"
#include "support/result_visitors.h"

namespace overbend::testing {

inline std::string result_bits(const StaticResults& results) {
  BitsVisitor bits;
  visit_key_results(results, bits);
  visit_sums(results, bits);
  visit_scene(results, bits);
  visit_touchdown(results.touchdown, bits);
  visit_solve(results.solve, bits);
  const auto extreme = [&](const ResultField& f, const Extreme& e) { visit_extreme_fields(f, e, bits); };
  if (results.overbend) visit_region(*results.overbend, extreme);
  if (results.tower) visit_region(*results.tower, extreme);
  visit_extreme_fields(ResultField{}, results.min_effective_tension, bits);
  visit_region(results.sagbend, extreme);
  for (const DerivedSection& section : results.sections) visit_section(section, bits);
  for (const StructureResult& structure : results.structures) visit_structure(structure, bits);
  for (const Station& station : results.stations) visit_station(station, bits);
  for (const SupportResult& support : results.supports) {
    visit_support(support, bits);
    for (const RowResult& row : support.rows) {
      visit_row(row, bits);
      for (const RollerResult& roller : row.rollers) visit_roller(roller, bits);
    }
  }
  if (results.head) visit_head(*results.head, bits);
  if (results.cable) visit_cable(*results.cable, bits);
  if (results.far_anchor) visit_far_anchor(*results.far_anchor, bits);
  if (results.bed) visit_laid_pipe(*results.bed, bits);
  for (const BedHeight& height : results.bed ? results.bed->heights : std::vector<BedHeight>{}) {
    visit_bed_height(height, bits);
  }
  for (const BedContactResult& contact : results.bed ? results.bed->contacts : std::vector<BedContactResult>{}) {
    visit_bed_contact(contact, bits);
  }
  for (const FreeSpanResult& span : results.bed ? results.bed->spans : std::vector<FreeSpanResult>{}) {
    visit_free_span(span, bits);
  }
  if (results.route) visit_route(*results.route, bits);
  for (const RollerFrictionCase& limit : results.roller_friction) visit_friction_case(limit, bits);
  visit_checks(results.checks, bits);
  return bits.text;
}

}  // namespace overbend::testing
