#include "report/page/listing.h"
#include "report/page/sections.h"

namespace overbend {
namespace {

Table extremes_table(const BedResults& bed) {
  Table table{"",
              {TableColumn("Of the laid pipe"), TableColumn::texts("Value"), TableColumn("Unit"), {"Astern", "m", 1}},
              "summary"};
  const auto row = [&](const char* name, double value, const ShownUnit& unit, std::optional<double> astern = {}) {
    table.row({name, shown_number(value, unit, 1), unit.name, astern});
  };
  row("Largest penetration", bed.max_penetration, section_length(), bed.penetration_x);
  row("Largest hogging moment", bed.hogging_moment, shown_unit("N m"), bed.hogging_x);
  row("Largest sagging moment", bed.sagging_moment, shown_unit("N m"), bed.sagging_x);
  row("Largest bending stress", bed.bending_stress, shown_unit("Pa"));
  row("Tension at the far end", bed.tail_tension, shown_unit("N"));
  return table;
}

Table contacts_table(const BedResults& bed) {
  Table table{"",
              {TableColumn("Contact"), {"from", "m", 2}, {"to", "m", 2}, {"Penetration", section_length(), 1}},
              "dense summary"};
  for (const BedContactResult& contact : bed.contacts) {
    table.row({std::to_string(table.rows.size() + 1), contact.x_from, contact.x_to, contact.max_penetration});
  }
  return table;
}

Blocks spans(const BedResults& bed) {
  if (bed.spans.empty()) return block::paragraph("The laid pipe is in contact with the seabed along its whole length.");
  Table table{"",
              {TableColumn("Free span"),
               {"from", "m", 2},
               {"to", "m", 2},
               {"Length", "m", 2},
               {"Gap", "m", 3},
               {"at", "m", 1},
               {"Sagging moment", "N m", 1},
               {"at", "m", 1},
               {"Bending stress", "Pa", 1}},
              "dense summary"};
  for (const FreeSpanResult& span : bed.spans) {
    table.row({std::to_string(table.rows.size() + 1), span.x_from, span.x_to, span.length, span.max_gap, span.gap_x,
               span.sagging_moment, span.moment_x, span.bending_stress});
  }
  return table;
}

}  // namespace

Blocks laid_pipe_section(const StaticResults& results) {
  if (!results.bed) return {};
  return block::section(
      "laid-pipe", "Pipe on the seabed",
      extremes_table(*results.bed) + contacts_table(*results.bed) + spans(*results.bed) +
          block::remark("Positions are measured astern of the stern shoe, lengths along the unstressed pipe. Gaps "
                        "are normal to the seabed, from the underside of the pipe. Gaps of a few millimetres "
                        "depend on the stiffness of the seabed."));
}

}  // namespace overbend
