#include <fmt/format.h>

#include <algorithm>
#include <numbers>

#include "report/page/html.h"
#include "report/page/places.h"
#include "report/page/quantity.h"
#include "report/page/sections.h"

namespace overbend {
namespace {

using html::fixed;

/// A line of the static summary without a support.
void plain_row(html::Table& table, const StaticResults& results, const Station& at, const std::string& part,
               const std::string& place) {
  const Vec3 p = ship_point(results, at.p_W);
  table.row({place, part, shown_number(from_tensioner(results, at.s), "m", 2), shown_number(p.x(), "m", 2),
             shown_number(p.y(), "m", 2), shown_number(p.z(), "m", 2), "", "", "", "",
             forces().text(at.effective_tension, 1), moments().text(at.bending_moment, 1),
             stresses().text(at.bending_stress, 1), strains().text(at.strain, 4), stresses().text(at.von_mises, 1),
             fixed(yield_percent(results, at.s, at.von_mises), 1)});
}

/// A line of the static summary at a box: the pipe's place at its middle, the pipe's largest values over its length.
void support_row(html::Table& table, const StaticResults& results, const SupportResult& box) {
  const Station at = station_at(results, box.s);
  const Vec3 p = ship_point(results, at.p_W);
  table.row({box.name, box.stinger ? "STINGER" : "LAYBARGE", shown_number(from_tensioner(results, box.s), "m", 2),
             shown_number(p.x(), "m", 2), shown_number(p.y(), "m", 2), shown_number(p.z(), "m", 2),
             forces().text(box.vertical, 1), forces().text(box.lateral, 1), shown_number(box.separation, "m", 4),
             box.has_sides ? shown_number(box.separation_lateral, "m", 4) : "", forces().text(box.effective_tension, 1),
             moments().text(box.bending_moment, 1), stresses().text(box.bending_stress, 1),
             strains().text(box.strain, 4), stresses().text(box.von_mises, 1),
             fixed(yield_percent(results, box.s, box.von_mises), 1)});
}

int rows_in_contact(const SupportResult& box) {
  return static_cast<int>(
      std::count_if(box.rows.begin(), box.rows.end(), [](const RowResult& row) { return row.reaction > 0.0; }));
}

double largest_roller(const SupportResult& box) {
  double largest = 0.0;
  for (const RowResult& row : box.rows) {
    for (const RollerResult& roller : row.rollers) {
      largest = std::max(largest, roller.reaction);
    }
  }
  return largest;
}

}  // namespace

std::string static_summary_table(const StaticResults& results) {
  html::Table table("",
                    {{"Station", "", true},
                     {"Pipe section", "", true},
                     {"Along pipe", shown_name("m")},
                     {"X", shown_name("m")},
                     {"Y", shown_name("m")},
                     {"Z", shown_name("m")},
                     {"vert.", shown_name("N")},
                     {"horiz.", shown_name("N")},
                     {"vert.", shown_name("m")},
                     {"horiz.", shown_name("m")},
                     {"Tension", shown_name("N")},
                     {"Moment", shown_name("N m")},
                     {"Bending stress", shown_name("Pa")},
                     {"Strain", "%"},
                     {"von Mises", shown_name("Pa")},
                     {"Yield", "%"}},
                    "dense summary");
  table.groups({{"", 2}, {"Pipe axis", 4}, {"Support reaction", 2}, {"Support separation", 2}, {"Pipe", 6}});
  plain_row(table, results, results.stations.back(), "TENSIONER", "tensioner");
  for (const SupportResult& box : results.supports) {
    support_row(table, results, box);
  }
  plain_row(table, results, station_at(results, results.sagbend.von_mises.s), "SAGBEND", "sagbend max.");
  plain_row(table, results, station_at(results, results.touchdown.s), "SEABED", "touchdown");
  plain_row(table, results, results.stations.front(), "SEABED", "anchor");
  return table.str() +
         "<p class=\"small\">X: horizontal, astern of the stern shoe; Y: to port of the vessel's axis; Z: above the "
         "mean "
         "water level. Horizontal reaction: across the box, positive to port. Pipe at a support: position at the "
         "middle of the box, maxima over its length. "
         "Separation: "
         "clear distance between pipe and roller, the smallest of the box's bottom rollers (vertical) and side rollers "
         "(horizontal); negative is penetration due to the contact stiffness or, if the pipe has passed the end of a "
         "side roller, its distance beyond the line of that roller.</p>\n";
}

std::string support_table(const StaticResults& results) {
  if (results.supports.empty()) {
    return "";
  }
  html::Table table("Roller boxes",
                    {{"Box", "", true},
                     {"On", "", true},
                     {"X", shown_name("m")},
                     {"Z", shown_name("m")},
                     {"Incline", shown_name("rad")},
                     {"Length", shown_name("m")},
                     {"resultant", shown_name("N")},
                     {"vertical", shown_name("N")},
                     {"longit.", shown_name("N")},
                     {"lateral", shown_name("N")},
                     {"Largest roller", shown_name("N")},
                     {"Rows loaded", ""},
                     {"bottom", shown_name("m")},
                     {"sides", shown_name("m")}},
                    "dense boxes");
  table.groups({{"", 6}, {"Reaction on the pipe", 4}, {"", 2}, {"Smallest separation", 2}});
  for (const SupportResult& box : results.supports) {
    const Vec3 p = ship_point(results, box.p_W);
    table.row({box.name, box.stinger ? "stinger" : "ramp", shown_number(p.x(), "m", 3), shown_number(p.z(), "m", 3),
               angles().text(box.inclination, 2), shown_number(box.length, "m", 3), forces().text(box.reaction, 1),
               forces().text(box.vertical, 1), forces().text(box.longitudinal, 1), forces().text(box.lateral, 1),
               forces().text(largest_roller(box), 1), fmt::format("{} of {}", rows_in_contact(box), box.rows.size()),
               shown_number(box.separation, "m", 4),
               box.has_sides ? shown_number(box.separation_lateral, "m", 4) : ""});
  }
  return table.str() +
         "<p class=\"small\">X, Z: middle of the box, where the underside of the coated pipe rests; Z above the mean "
         "water "
         "level. Longitudinal: along the box, positive astern; lateral: positive to port.</p>\n";
}

std::string rollers_section(const StaticResults& results) {
  if (results.supports.empty()) {
    return "";
  }
  html::Table table("",
                    {{"Box", "", true},
                     {"Row", ""},
                     {"Roller", "", true},
                     {"normal", shown_name("N")},
                     {"vertical", shown_name("N")},
                     {"longit.", shown_name("N")},
                     {"lateral", shown_name("N")},
                     {"Separation", shown_name("m")},
                     {"Off end", shown_name("m")}},
                    "dense rollers");
  table.groups({{"", 3}, {"Reaction on the pipe", 4}, {"", 2}});
  int count = 0;
  for (const SupportResult& box : results.supports) {
    for (std::size_t row = 0; row < box.rows.size(); ++row) {
      for (const RollerResult& r : box.rows[row].rollers) {
        ++count;
        table.row({box.name, std::to_string(row + 1), word(r.position), forces().text(r.reaction, 2),
                   forces().text(r.vertical, 2), forces().text(r.longitudinal, 2), forces().text(r.lateral, 2),
                   shown_number(r.separation, "m", 4), shown_number(r.off_end, "m", 3)},
                  r.reaction > 0.0 ? "loaded" : "");
      }
    }
  }
  return html::section("rollers", "Appendix: individual rollers, static state",
                       html::folded(fmt::format("All {} rollers", count), table.str()));
}

}  // namespace overbend
