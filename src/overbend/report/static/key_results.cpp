#include <fmt/format.h>

#include <algorithm>

#include <array>

#include "report/page/html.h"
#include "report/page/page.h"
#include "report/page/places.h"
#include "report/page/quantity.h"
#include "report/page/sections.h"
#include "results/fields/static_values.h"

namespace overbend {
namespace {

using html::fixed;
using html::tile;

double utilisation(const StaticResults& results, const Extreme& extreme) {
  return yield_percent(results, extreme.s, extreme.value);
}

std::string stress_note(const StaticResults& results, const Extreme& extreme) {
  const std::string place = place_name(results, extreme.s);
  const std::string where = place == "sagbend" ? "X = " + shown(ship_point(results, extreme.p_W).x(), "m", 1) : place;
  return fmt::format("{} % of yield, at {}", fixed(utilisation(results, extreme), 1), where);
}

std::string stress_tile(const StaticResults& results, const std::string& name, const Extreme& extreme) {
  return tile(name, stresses().text(extreme.value, 1), stresses().unit, stress_note(results, extreme),
              utilisation(results, extreme) > 100.0);
}

std::string tiles(const StaticResults& r) {
  std::string out = "<div class=\"tiles\">\n";
  out += tile("Top tension", forces().text(r.top_tension, 1), forces().unit, "effective, at the tensioner");
  out += tile("Bottom tension", forces().text(r.bottom_tension, 1), forces().unit, "horizontal, at touchdown");
  if (r.overbend) {
    out += stress_tile(r, "Overbend von Mises", r.overbend->von_mises);
  }
  out += stress_tile(r, "Sagbend von Mises", r.sagbend.von_mises);
  out += tile("Lay-back", shown_number(r.lay_back, "m", 1), shown_name("m"), "stern shoe to touchdown");
  out += tile("Departure angle", angles().text(r.departure_angle, 2), angles().unit,
              "at " + (r.last_support.empty() ? std::string("the tensioner") : r.last_support));
  if (r.supports.empty()) {  // in J-lay the sagbend is all there is
    out += tile("Suspended length", shown_number(r.suspended_length, "m", 1), shown_name("m"),
                "along the pipe, to touchdown");
    out += tile("Sagbend moment", moments().text(r.sagbend.bending_moment.value, 1), moments().unit,
                shown(from_tensioner(r, r.sagbend.bending_moment.s), "m", 1) + " along the pipe");
    out += tile("Sagbend strain", strains().text(r.sagbend.strain.value, 4), strains().unit, "longitudinal, maximum");
  }
  if (!r.supports.empty()) {
    out += tile("Largest roller reaction", forces().text(r.largest_reaction, 1), forces().unit,
                "at " + r.largest_reaction_support);
  }
  if (r.stinger_tip_clearance) {
    out += tile("Stinger tip clearance", clearances().text(*r.stinger_tip_clearance, 1), clearances().unit,
                "pipe to the last bottom roller");
  }
  return out + "</div>\n";
}

/// Lay quantities: name, value and unit of each.
std::vector<std::array<std::string, 3>> lay_quantities(const StaticResults& r) {
  std::vector<std::array<std::string, 3>> rows;
  const auto row = [&](const std::string& name, const std::string& value, const std::string& unit) {
    rows.push_back({name, value, unit});
  };
  row("Tension at the tensioner (effective)", forces().text(r.top_tension, 2), forces().unit);
  row("Largest effective tension", forces().text(r.largest_tension, 2), forces().unit);
  row("Horizontal tension at touchdown", forces().text(r.bottom_tension, 2), forces().unit);
  if (r.residual_curvature > 0.0) {
    row("Residual curvature at touchdown", shown_number(r.residual_curvature, "1/m", 5), shown_name("1/m"));
  }
  row("Lay-back, stern shoe to touchdown", shown_number(r.lay_back, "m", 2), shown_name("m"));
  row("Tensioner to touchdown, horizontal", shown_number(r.top_to_touchdown, "m", 2), shown_name("m"));
  row("Tensioner to touchdown, along the pipe", shown_number(r.length_top_to_touchdown, "m", 2), shown_name("m"));
  row("Suspended length", shown_number(r.suspended_length, "m", 2), shown_name("m"));
  row("Tensioner to anchor, along the pipe", shown_number(r.total_length, "m", 2), shown_name("m"));
  row(r.last_support.empty() ? "Departure angle, at the tensioner" : "Departure angle, at " + r.last_support,
      angles().text(r.departure_angle, 3), angles().unit);
  row("Touchdown, drift to port of the vessel's axis", shown_number(ship_point(r, r.touchdown.p_W).y(), "m", 2),
      shown_name("m"));
  if (r.stinger_tip_clearance) {
    row("Stinger tip clearance (negative: in contact)", shown_number(*r.stinger_tip_clearance, "m", 4),
        shown_name("m"));
  }
  if (r.ramp_fitted_radius) {
    row("Ramp, radius of the circle fitted to its boxes", shown_number(*r.ramp_fitted_radius, "m", 1), shown_name("m"));
  }
  if (r.stinger_fitted_radius) {
    row("Stinger, radius of the circle fitted to its boxes", shown_number(*r.stinger_fitted_radius, "m", 1),
        shown_name("m"));
  }
  if (!r.supports.empty()) {
    row("Largest reaction of one roller, at " + r.largest_reaction_support, forces().text(r.largest_reaction, 2),
        forces().unit);
    row("Smallest separation of a bottom roller", shown_number(r.smallest_separation, "m", 4), shown_name("m"));
  }
  return rows;
}

/// In two halves beside each other where there is room.
std::string lay_table(const StaticResults& r) {
  const std::vector<std::array<std::string, 3>> rows = lay_quantities(r);
  const std::vector<html::Head> head = {{"Quantity", "", true}, {"Value", ""}, {"Unit", "", true}};
  html::Table first("", head, "plain");
  html::Table second("", head, "plain");
  for (std::size_t i = 0; i < rows.size(); ++i) {
    (2 * i < rows.size() ? first : second).row({rows[i][0], rows[i][1], rows[i][2]});
  }
  return "<h3>Lay configuration</h3>\n<div class=\"columns lay\">\n" + first.str() + second.str() + "</div>\n";
}

/// Largest values of a region with their places.
std::string region_table(const StaticResults& results, const std::string& caption, const RegionResult& region) {
  html::Table table(caption,
                    {{"Largest", "", true},
                     {"Value", ""},
                     {"Yield", "%"},
                     {"Along pipe", shown_name("m")},
                     {"X", shown_name("m")},
                     {"Z", shown_name("m")},
                     {"Place", "", true}},
                    "plain");
  visit_region(region, [&](const ResultField& field, const Extreme& extreme) {
    const Quantity q = quantity(field.name, std::string(field.units));
    const bool stress = field.units == "Pa";  // compared with yield
    const Vec3 p = ship_point(results, extreme.p_W);
    table.row({fmt::format("{} [{}]", q.name, q.unit), q.text(extreme.value),
               stress ? fixed(utilisation(results, extreme), 1) : "",
               shown_number(from_tensioner(results, extreme.s), "m", 2), shown_number(p.x(), "m", 2),
               shown_number(p.z(), "m", 2), place_name(results, extreme.s)});
  });
  return table.str();
}

}  // namespace

std::string title_block(const std::string& kind, const std::string& title,
                        const std::vector<std::pair<std::string, std::string>>& entries, const std::string& control,
                        const std::string& document) {
  const auto written = std::ranges::find(entries, "Written", &std::pair<std::string, std::string>::first);
  const std::string when = written != entries.end() ? written->second : written_now();
  return page_margins({document, title, kind, when}) + "<header>\n<div class=\"kind\">" + html::escape(kind) +
         "</div>\n<h1>" + html::escape(title) + "</h1>\n" + control + html::entries(entries) + "</header>\n";
}

std::vector<std::pair<std::string, std::string>> subject_entries(const StaticResults& results,
                                                                 const std::optional<Description>& description) {
  std::vector<std::pair<std::string, std::string>> entries;
  if (results.moorings && description) entries.emplace_back("Vessel", description->vessel.name);
  if (results.moorings) entries.emplace_back("Mooring lines", std::to_string(results.moorings->rest.moorings.size()));
  if (!results.lines.empty()) entries.emplace_back("Lines", std::to_string(results.lines.size()));
  if (!results.has_pipe()) return entries;
  return {
      {"Vessel", results.vessel_name},
      {"Pipe", fmt::format("{} steel, {} over the coating", shown(results.steel_outer_diameter, section_length(), 1),
                           shown(results.pipe_outer_diameter, section_length(), 1))},
      {"Water depth", shown(results.water_depth, "m", 2)},
      {"Method", results.supports.empty() ? "J-lay" : "S-lay"}};
}

std::string status_words(const std::string& state, std::size_t findings) {
  return findings == 0 ? state : fmt::format("{}, {} finding{}", state, findings, findings == 1 ? "" : "s");
}

std::string key_results(const StaticResults& results, const std::string& id, const std::string& heading) {
  if (!results.has_pipe()) return "";
  std::string body = tiles(results) + "<div class=\"results\">\n";
  if (results.overbend) {
    body += region_table(results, "Overbend: tensioner to the inflection below the last support in contact",
                         *results.overbend);
  }
  body += region_table(results,
                       results.overbend ? "Sagbend: from there to touchdown" : "Suspended pipe: tensioner to touchdown",
                       results.sagbend);
  body += "</div>\n" + lay_table(results);
  body +=
      "<p class=\"small\">Along pipe: unstressed length from the tensioner. X: horizontal, astern of the stern shoe. "
      "Y: to port of the vessel's axis. Z: above the mean water level. All refer to the pipe's axis.</p>\n";
  return html::section(id, heading, body);
}

}  // namespace overbend
