#include "report/static/passage_section.h"

#include <fmt/format.h>

#include "report/page/html.h"
#include "report/page/quantity.h"

namespace overbend {
namespace {

std::string place(const PassagePeak& peak) {
  return peak.stage.empty() ? "-" : shown_number(peak.passed, "m", 2);
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
        "The largest strain of the pipe beside the structure is {} %, {}; its von Mises stress is at "
        "most {}.",
        strains().text(passage.strain.value, 4), at(passage.strain), shown(passage.von_mises.value, "Pa", 1)));
  }
  return list;
}

}  // namespace

std::string passage_section(const PassageResults& passage) {
  html::Table table("",
                    {{"Box", "", true},
                     {"reaction", shown_name("N")},
                     {"structure at", shown_name("m")},
                     {"reaction", shown_name("N")},
                     {"structure at", shown_name("m")},
                     {"strain", "%"},
                     {"structure at", shown_name("m")}},
                    "dense summary");
  table.groups({{"", 1}, {"Single roller", 2}, {"Whole box", 2}, {"Line over the box", 2}});
  for (const PassageBox& box : passage.boxes) {
    table.row({box.name, forces().text(box.roller.value, 1), place(box.roller), forces().text(box.reaction.value, 1),
               place(box.reaction), strains().text(box.strain.value, 4), place(box.strain)});
  }
  return html::section(
      "passage", fmt::format("Passage of {}", passage.structure),
      html::list(findings(passage)) + (passage.boxes.empty() ? "" : table.str()) +
          "<p class=\"small\">Largest over all stages; distances are along the line from the tensioner "
          "to the middle of the structure.</p>\n");
}

}  // namespace overbend
