#include <fmt/format.h>

#include <array>

#include "report/page/listing.h"
#include "report/page/quantity.h"
#include "report/page/sections.h"
#include "results/fields/location_names.h"
#include "results/fields/static_scalars.h"

namespace overbend {
namespace {

double utilisation(const StaticResults& results, const Extreme& extreme) {
  return yield_percent(results, extreme.s, extreme.value);
}

std::string stress_note(const StaticResults& results, const Extreme& extreme) {
  const std::string place = location_name(results, extreme.s);
  const std::string where = place == "sagbend" ? "X = " + shown(ship_point(results, extreme.p_W).x(), "m", 1) : place;
  return fmt::format("{} % of yield, at {}", fixed(utilisation(results, extreme), 1), where);
}

Blocks tiles(const StaticResults& r) {
  std::vector<Tile> all;
  const auto add = [&](const char* name, double value, const ShownUnit& unit, int digits, const std::string& note) {
    all.push_back({name, shown_number(value, unit, digits), std::string(unit.name), note});
  };
  const auto add_stress = [&](const char* name, const Extreme& extreme) {
    add(name, extreme.value, shown_unit("Pa"), 1, stress_note(r, extreme));
    all.back().over = utilisation(r, extreme) > 100.0;
  };
  add("Top tension", r.top_tension, shown_unit("N"), 1, "effective, at the tensioner");
  add("Bottom tension", r.bottom_tension, shown_unit("N"), 1, "horizontal, at touchdown");
  if (r.overbend) add_stress("Overbend von Mises", r.overbend->von_mises);
  add_stress("Sagbend von Mises", r.sagbend.von_mises);
  add("Lay-back", r.lay_back, shown_unit("m"), 1, "stern shoe to touchdown");
  add("Departure angle", r.departure_angle, shown_unit("rad"), 2,
      "at " + (r.last_support.empty() ? "the tensioner" : r.last_support));
  if (r.supports.empty()) {  // in J-lay the sagbend is the only region
    add("Suspended length", r.suspended_length, shown_unit("m"), 1, "along the pipe, to touchdown");
    add("Sagbend moment", r.sagbend.bending_moment.value, shown_unit("N m"), 1,
        shown(from_tensioner(r, r.sagbend.bending_moment.s), "m", 1) + " along the pipe");
    add("Sagbend strain", r.sagbend.strain.value, shown_unit("strain", "1"), 4, "longitudinal, maximum");
  } else {
    add("Largest roller reaction", r.max_reaction, shown_unit("N"), 1, "at " + r.max_reaction_support);
  }
  if (r.stinger_tip_clearance) {
    add("Stinger tip clearance", *r.stinger_tip_clearance, section_length(), 1, "pipe to the last bottom roller");
  }
  return block::tiles(all);
}

/// Name, value and unit of each lay quantity.
std::vector<std::array<std::string, 3>> lay_quantities(const StaticResults& r) {
  std::vector<std::array<std::string, 3>> rows;
  const auto row = [&](const std::string& name, double value, std::string_view si, int digits) {
    rows.push_back({name, shown_number(value, si, digits), shown_name(si)});
  };
  row("Tension at the tensioner (effective)", r.top_tension, "N", 2);
  row("Largest effective tension", r.max_tension, "N", 2);
  row("Horizontal tension at touchdown", r.bottom_tension, "N", 2);
  if (r.residual_curvature > 0.0) row("Residual curvature at touchdown", r.residual_curvature, "1/m", 5);
  row("Lay-back, stern shoe to touchdown", r.lay_back, "m", 2);
  row("Tensioner to touchdown, horizontal", r.top_to_touchdown, "m", 2);
  row("Tensioner to touchdown, along the pipe", r.length_top_to_touchdown, "m", 2);
  row("Suspended length", r.suspended_length, "m", 2);
  row("Tensioner to anchor, along the pipe", r.total_length, "m", 2);
  row("Departure angle, at " + (r.last_support.empty() ? "the tensioner" : r.last_support), r.departure_angle, "rad",
      3);
  row("Touchdown, drift to port of the vessel's axis", ship_point(r, r.touchdown.p_W).y(), "m", 2);
  if (r.stinger_tip_clearance) {
    row("Stinger tip clearance (negative: in contact)", *r.stinger_tip_clearance, "m", 4);
  }
  if (r.ramp_fitted_radius) row("Ramp, radius of the circle fitted to its boxes", *r.ramp_fitted_radius, "m", 1);
  if (r.stinger_fitted_radius) {
    row("Stinger, radius of the circle fitted to its boxes", *r.stinger_fitted_radius, "m", 1);
  }
  if (!r.supports.empty()) {
    row("Largest reaction of one roller, at " + r.max_reaction_support, r.max_reaction, "N", 2);
    row("Smallest separation of a bottom roller", r.min_bottom_separation, "m", 4);
  }
  return rows;
}

/// Two halves side by side if the width permits.
Blocks lay_tables(const StaticResults& r) {
  Listing first(""), second("");
  const auto rows = lay_quantities(r);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    (2 * i < rows.size() ? first : second).add(rows[i][0], rows[i][1], rows[i][2]);
  }
  return block::subheading("Lay configuration") + block::group("columns lay", first.table() + second.table());
}

/// Maxima of a region with their positions.
Table region_table(const StaticResults& results, const std::string& title, const RegionResult& region) {
  Table table{title,
              {TableColumn("Largest"),
               TableColumn::texts("Value"),
               {"Yield", "%", 1},
               {"Along pipe", "m", 2},
               {"X", "m", 2},
               {"Z", "m", 2},
               TableColumn("Place")}};
  visit_region(region, [&](const ResultField& field, const Extreme& extreme) {
    const Quantity q = quantity(field.name, std::string(field.units));
    const bool stress = field.units == "Pa";  // compared with yield
    const Vec3 p = ship_point(results, extreme.p_W);
    table.row({fmt::format("{} [{}]", q.name, q.unit), q.text(extreme.value),
               stress ? TableCell(utilisation(results, extreme)) : TableCell(), from_tensioner(results, extreme.s),
               p.x(), p.z(), location_name(results, extreme.s)});
  });
  return table;
}

}  // namespace

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

std::string status_label(const std::string& state, std::size_t findings) {
  return findings == 0 ? state : fmt::format("{}, {} finding{}", state, findings, findings == 1 ? "" : "s");
}

Blocks key_results(const StaticResults& results, const std::string& id, const std::string& heading) {
  if (!results.has_pipe()) return {};
  Blocks regions;
  if (results.overbend) {
    regions += region_table(results, "Overbend: tensioner to the inflection below the last support in contact",
                            *results.overbend);
  }
  regions += region_table(
      results,
      results.overbend ? "Sagbend: from the inflection to touchdown" : "Suspended pipe: tensioner to touchdown",
      results.sagbend);
  return block::section(
      id, heading,
      tiles(results) + block::group("results", regions) + lay_tables(results) +
          block::remark("Along pipe: unstressed length from the tensioner. X: horizontal, astern of the stern shoe. "
                        "Y: to port of the vessel's axis. Z: above the mean water level. All refer to the pipe's "
                        "axis."));
}

}  // namespace overbend
