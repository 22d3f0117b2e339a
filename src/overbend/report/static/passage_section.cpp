#include "report/static/passage_section.h"

#include <fmt/format.h>

#include "report/page/quantity.h"

namespace overbend {
namespace {

TableCell place(const PassagePeak& peak) {
  return peak.stage.empty() ? TableCell("-") : TableCell(peak.passed);
}

std::string at(const PassagePeak& peak) {
  return fmt::format("with the structure {} from the tensioner ({})", shown(peak.passed, "m", 2), peak.stage);
}

std::vector<std::string> findings(const PassageResults& passage) {
  std::vector<std::string> list;
  if (!passage.reaction.stage.empty()) {
    list.push_back(fmt::format("The largest reaction of a roller under the structure is {}, {}, {}.",
                               shown(passage.reaction.value, "N", 1), passage.support, at(passage.reaction)));
  }
  if (!passage.strain.stage.empty()) {
    list.push_back(fmt::format(
        "The largest strain of the pipe next to the structure is {} %, {}; its von Mises stress is at most {}.",
        strains().text(passage.strain.value, 4), at(passage.strain), shown(passage.von_mises.value, "Pa", 1)));
  }
  return list;
}

}  // namespace

Blocks passage_section(const PassageResults& passage) {
  Table table{"",
              {TableColumn("Box"),
               {"reaction", "N", 1},
               {"structure at", "m", 2},
               {"reaction", "N", 1},
               {"structure at", "m", 2},
               {"strain", shown_unit("strain", "1"), 4},
               {"structure at", "m", 2}},
              "dense summary"};
  table.groups({{"", 1}, {"Single roller", 2}, {"Whole box", 2}, {"Line over the box", 2}});
  for (const PassageBox& box : passage.boxes) {
    table.row({box.name, box.roller.value, place(box.roller), box.reaction.value, place(box.reaction), box.strain.value,
               place(box.strain)});
  }
  return block::section("passage", fmt::format("Passage of {}", passage.structure),
                        block::list(findings(passage)) + table +
                            block::remark("Maxima over all stages; distances are along the line from the tensioner "
                                          "to the middle of the structure."));
}

}  // namespace overbend
