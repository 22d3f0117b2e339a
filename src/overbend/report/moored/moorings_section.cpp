#include "report/moored/moorings_section.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "base/ranges.h"
#include "report/page/figure_list.h"
#include "results/tables/mooring_tables.h"

namespace overbend {
namespace {

/// A tension and its utilisation of a capacity.
Tile tension_tile(const std::string& name, double tension, const std::string& line, const std::optional<double>& use,
                  const char* capacity) {
  return {name, shown_number(tension, "N", 1), shown_name("N"),
          use ? fmt::format("{}, {} % of its {}", line, fixed(100.0 * *use, 1), capacity) : line,
          use.value_or(0.0) > 1.0};
}

Blocks tiles(const MooredState& state) {
  std::vector<const MooringLineResult*> lines;
  for (const MooringLineResult& line : state.moorings) {
    if (!line.parted) lines.push_back(&line);
  }
  std::vector<Tile> all;
  if (!lines.empty()) {
    const MooringLineResult& hardest = **ranges::max_element(lines, {}, &MooringLineResult::fairlead_tension);
    const MooringLineResult& anchor = **ranges::max_element(lines, {}, &MooringLineResult::anchor_tension);
    const MooringLineResult& min_on_bed = **ranges::min_element(lines, {}, &MooringLineResult::on_bed);
    all = {tension_tile("Largest line tension", hardest.fairlead_tension, hardest.name, hardest.utilisation,
                        "breaking load"),
           tension_tile("Largest anchor load", anchor.anchor_tension, anchor.name, anchor.anchor_utilisation,
                        "holding power"),
           {"Minimum length on the seabed", shown_number(min_on_bed.on_bed, "m", 1), shown_name("m"), min_on_bed.name,
            min_on_bed.on_bed <= 0.0}};
  }
  const VesselResult& vessel = state.vessel;
  all.push_back({"Offset of midship", shown_number(std::hypot(vessel.surge, vessel.sway), "m", 3), shown_name("m"),
                 fmt::format("yaw {} deg, from the nominal pose", shown_number(vessel.yaw, "rad", 3))});
  return block::tiles(all);
}

Blocks line_table(const std::vector<MooringLineResult>& lines) {
  return Blocks(moorings_at_rest(lines)) +
         block::remark(
             "Azimuth: of the anchor from the fairlead, clockwise from north. Tension, its horizontal component "
             "and declination at the fairlead; uplift angle above horizontal at the anchor. Lengths are "
             "unstressed. Utilisations are shares of the breaking load and of the anchor's holding power, without "
             "safety factors.");
}

Table value_table(const std::string& title) {
  return {title, {TableColumn(""), TableColumn::texts("Value"), TableColumn("Unit")}};
}

void add_value(Table& table, const char* name, double value, std::string_view si, int digits) {
  table.row({name, shown_number(value, si, digits), shown_name(si)});
}

Table offset_table(const VesselResult& v) {
  Table table = value_table("Static offset from nominal position");
  add_value(table, "Surge, forward", v.surge, "m", 3);
  add_value(table, "Sway, to port", v.sway, "m", 3);
  add_value(table, "Heave, up", v.heave, "m", 4);
  add_value(table, "Roll, starboard down", v.roll, "rad", 3);
  add_value(table, "Pitch, bow down", v.pitch, "rad", 3);
  add_value(table, "Yaw, bow to port", v.yaw, "rad", 3);
  return table;
}

Table thrust_table(const std::vector<double>& thrust) {
  Table table = value_table("Static thrust of dynamic positioning");
  if (thrust.size() != 3) return table;
  add_value(table, "Thrust ahead", thrust[0], "N", 1);
  add_value(table, "Thrust to port", thrust[1], "N", 1);
  add_value(table, "Moment, bow to port", thrust[2], "N m", 0);
  return table;
}

Table period_table(const VesselResult& v) {
  Table table{"Natural periods, undamped", {TableColumn("Mode"), {"Period", "s", 2}}};
  for (const PeriodResult& mode : v.natural_periods) table.row({mode.mode, mode.period});
  return table;
}

/// Display factor of a force or a moment (rows) by a shift or a rotation (columns).
double stiffness_factor(std::size_t row, std::size_t column) {
  return shown_unit("N").factor * std::pow(shown_unit("m").factor, (row < 3 ? 0 : 1) - (column < 3 ? 1 : 0));
}

/// Rotations in radians. Magnitudes differ by a factor of ten thousand.
Blocks stiffness_table(const std::vector<double>& stiffness) {
  if (stiffness.size() != 36) return {};
  constexpr std::array<const char*, 6> kFreedoms = {"surge", "sway", "heave", "roll", "pitch", "yaw"};
  const double max_stiffness = std::abs(*std::max_element(
      stiffness.begin(), stiffness.end(), [](double a, double b) { return std::abs(a) < std::abs(b); }));
  Table table{fmt::format("Stiffness of lines, thrusters and water about midship [{0}/{1}, {0}, {0} {1}]",
                          shown_name("N"), shown_name("m")),
              {TableColumn("")}};
  for (std::size_t i = 0; i < 6; ++i) {
    table.column(TableColumn::texts(kFreedoms[i]));
    std::vector<TableCell> cells = {kFreedoms[i]};
    for (std::size_t k = 0; k < 6; ++k) {
      const double value = stiffness[6 * i + k];
      cells.push_back(std::abs(value) < 1e-9 * max_stiffness ? "0"
                                                             : fmt::format("{:.5g}", value * stiffness_factor(i, k)));
    }
    table.row(cells);
  }
  return block::folded("Stiffness matrix", table);
}

Blocks vessel_tables(const MooredState& state) {
  const VesselResult& vessel = state.vessel;
  return block::subheading("Vessel") +
         block::columns(offset_table(vessel) + thrust_table(state.thrust) + period_table(vessel)) +
         stiffness_table(vessel.stiffness);
}

const std::vector<Figure>& rest_figures() {
  static const std::vector<Figure> kFigures = {
      {"mooring_plan",
       "Plan of the moorings, north up. Solid: suspended part of a line; pale: on the seabed; tension at the fairlead",
       {"field"}},
      {"mooring_profile", "Mooring lines in profile, each in its own vertical plane; heights enlarged", {"rest"}},
  };
  return kFigures;
}

}  // namespace

Blocks moorings_section(const MooringResults& results) {
  const MooredState& rest = results.rest;
  if (rest.moorings.empty()) {
    return block::section("moorings", "Station keeping", tiles(rest) + vessel_tables(rest));
  }
  return block::section("moorings", "Moorings",
                        tiles(rest) + figure_list(rest_figures()) + line_table(rest.moorings) + vessel_tables(rest));
}

}  // namespace overbend
