#include "report/page/html.h"
#include "report/page/quantity.h"
#include "report/page/sections.h"

namespace overbend {
namespace {

std::string extremes_table(const BedResults& bed) {
  html::Table table(
      "", {{"Of the laid pipe", "", true}, {"Value", ""}, {"Unit", "", true}, {"Astern", shown_name("m")}}, "summary");
  table.row({"Largest penetration", clearances().text(bed.largest_penetration, 1), clearances().unit,
             shown_number(bed.penetration_x, "m", 1)});
  table.row({"Largest hogging moment", moments().text(bed.hogging_moment, 1), moments().unit,
             shown_number(bed.hogging_x, "m", 1)});
  table.row({"Largest sagging moment", moments().text(bed.sagging_moment, 1), moments().unit,
             shown_number(bed.sagging_x, "m", 1)});
  table.row({"Largest bending stress", stresses().text(bed.bending_stress, 1), stresses().unit, ""});
  table.row({"Tension at the far end", forces().text(bed.tail_tension, 1), forces().unit, ""});
  return table.str();
}

std::string contacts_table(const BedResults& bed) {
  html::Table table(
      "",
      {{"Contact", "", true}, {"from", shown_name("m")}, {"to", shown_name("m")}, {"Penetration", clearances().unit}},
      "dense summary");
  for (std::size_t i = 0; i < bed.contacts.size(); ++i) {
    const BedContactResult& contact = bed.contacts[i];
    table.row({std::to_string(i + 1), shown_number(contact.x_from, "m", 2), shown_number(contact.x_to, "m", 2),
               clearances().text(contact.largest_penetration, 1)});
  }
  return table.str();
}

std::string spans_table(const BedResults& bed) {
  if (bed.spans.empty()) return "<p>The laid pipe touches the seabed all along.</p>\n";
  html::Table table("",
                    {{"Free span", "", true},
                     {"from", shown_name("m")},
                     {"to", shown_name("m")},
                     {"Length", shown_name("m")},
                     {"Gap", shown_name("m")},
                     {"at", shown_name("m")},
                     {"Sagging moment", moments().unit},
                     {"at", shown_name("m")},
                     {"Bending stress", stresses().unit}},
                    "dense summary");
  for (std::size_t i = 0; i < bed.spans.size(); ++i) {
    const FreeSpanResult& span = bed.spans[i];
    table.row({std::to_string(i + 1), shown_number(span.x_from, "m", 2), shown_number(span.x_to, "m", 2),
               shown_number(span.length, "m", 2), shown_number(span.largest_gap, "m", 3),
               shown_number(span.gap_x, "m", 1), moments().text(span.sagging_moment, 1),
               shown_number(span.moment_x, "m", 1), stresses().text(span.bending_stress, 1)});
  }
  return table.str();
}

}  // namespace

std::string laid_pipe_section(const StaticResults& results) {
  if (!results.bed) return "";
  return html::section(
      "laid-pipe", "Pipe on the seabed",
      extremes_table(*results.bed) + contacts_table(*results.bed) + spans_table(*results.bed) +
          "<p class=\"small\">Places count astern of the stern shoe, lengths along the unstressed pipe. "
          "Gaps are square to the seabed, from the underside of the pipe. Gaps of a few "
          "millimetres depend on the stiffness of the seabed.</p>\n");
}

}  // namespace overbend
