#include "report/page/sections.h"

namespace overbend {

Blocks structures_section(const StaticResults& results) {
  const ShownUnit strain = shown_unit("strain", "1");
  Table table{"",
              {TableColumn("Structure"),
               {"From tensioner", "m", 2},
               {"astern", "m", 2},
               {"z", "m", 2},
               {"inclination", "rad", 2},
               {"Tension", "N", 1},
               {"Moment", "N m", 1},
               {"Roller", "N", 1},
               TableColumn("at"),
               {"von Mises", "Pa", 1},
               {"strain", strain, 4},
               {"von Mises", "Pa", 1},
               {"strain", strain, 4}},
              "dense summary"};
  table.groups({{"", 2}, {"Middle", 3}, {"In it", 2}, {"Carried by", 2}, {"Pipe above it", 2}, {"Pipe below it", 2}});
  for (const StructureResult& s : results.structures) {
    const bool carried = !s.support.empty();
    table.row({s.name, s.from_top, s.astern, s.p_W.z(), s.inclination, s.effective_tension, s.bending_moment,
               carried ? TableCell(s.reaction) : TableCell("-"), carried ? s.support : "-", s.upper.von_mises,
               s.upper.strain, s.lower.von_mises, s.lower.strain});
  }
  if (table.empty()) return {};
  return block::section("structures", "Structures in the line",
                        table + block::remark("Pipe above and below: maxima within two pipe diameters of the end "
                                              "towards the tensioner and of that towards the seabed, where the "
                                              "stiffness changes abruptly. The structure itself is not checked."));
}

}  // namespace overbend
