#include "report/page/html.h"
#include "report/page/places.h"
#include "report/page/quantity.h"
#include "report/page/sections.h"

namespace overbend {
namespace {

std::vector<std::string> cells_of(const StructureResult& s) {
  std::vector<std::string> cells = {s.name,
                                    shown_number(s.from_top, "m", 2),
                                    shown_number(s.astern, "m", 2),
                                    shown_number(s.p_W.z(), "m", 2),
                                    angles().text(s.inclination, 2),
                                    forces().text(s.effective_tension, 1),
                                    moments().text(s.bending_moment, 1),
                                    s.support.empty() ? "-" : forces().text(s.reaction, 1),
                                    s.support.empty() ? "-" : s.support};
  for (const StructureEndResult* end : {&s.upper, &s.lower}) {
    cells.push_back(stresses().text(end->von_mises, 1));
    cells.push_back(strains().text(end->strain, 4));
  }
  return cells;
}

}  // namespace

std::string structures_section(const StaticResults& results) {
  if (results.structures.empty()) return "";
  html::Table table("",
                    {{"Structure", "", true},
                     {"From tensioner", shown_name("m")},
                     {"astern", shown_name("m")},
                     {"z", shown_name("m")},
                     {"inclination", shown_name("rad")},
                     {"Tension", shown_name("N")},
                     {"Moment", shown_name("N m")},
                     {"Roller", shown_name("N")},
                     {"at", "", true},
                     {"von Mises", shown_name("Pa")},
                     {"strain", "%"},
                     {"von Mises", shown_name("Pa")},
                     {"strain", "%"}},
                    "dense summary");
  table.groups({{"", 2}, {"Middle", 3}, {"In it", 2}, {"Carried by", 2}, {"Pipe above it", 2}, {"Pipe below it", 2}});
  for (const StructureResult& structure : results.structures) table.row(cells_of(structure));
  return html::section("structures", "Structures in the line",
                       table.str() +
                           "<p class=\"small\">Pipe above and below: the largest within two pipe diameters of the end "
                           "towards the tensioner and of that towards the seabed, where the stiffness steps. The "
                           "structure itself is not checked.</p>\n");
}

}  // namespace overbend
