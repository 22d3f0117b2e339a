#include "report/moored/moorings_section.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "report/page/figure_list.h"
#include "report/page/html.h"
#include "report/page/quantity.h"

namespace overbend {
namespace {

using html::fixed;
using html::tile;

std::string length_text(const std::optional<double>& value, int digits) {
  return value ? shown_number(*value, "m", digits) : "-";
}

std::string use_note(const MooringLineResult& line) {
  return line.utilisation ? line.name + ", " + fixed(100.0 * *line.utilisation, 1) + " % of its breaking load"
                          : line.name;
}

std::string tiles(const MooredState& state) {
  std::string out = "<div class=\"tiles\">\n";
  if (const MooringLineResult* hardest = hardest_line(state)) {
    out += tile("Largest line tension", shown_number(hardest->fairlead_tension, "N", 1), forces().unit,
                use_note(*hardest), hardest->utilisation.value_or(0.0) > 1.0);
  }
  const MooringLineResult* anchor = nullptr;
  const MooringLineResult* shortest = nullptr;
  for (const MooringLineResult& line : state.moorings) {
    if (line.parted) continue;
    if (anchor == nullptr || line.anchor_tension > anchor->anchor_tension) anchor = &line;
    if (shortest == nullptr || line.on_bed < shortest->on_bed) shortest = &line;
  }
  if (anchor != nullptr) {
    const std::optional<double>& use = anchor->anchor_utilisation;
    out += tile("Largest anchor load", shown_number(anchor->anchor_tension, "N", 1), forces().unit,
                anchor->name + (use ? ", " + fixed(100.0 * *use, 1) + " % of its holding power" : ""),
                use.value_or(0.0) > 1.0);
    out += tile("Least length on the bed", shown_number(shortest->on_bed, "m", 1), shown_name("m"), shortest->name,
                shortest->on_bed <= 0.0);
  }
  const VesselResult& vessel = state.vessel;
  out += tile("Offset of midship", shown_number(std::hypot(vessel.surge, vessel.sway), "m", 3), shown_name("m"),
              fmt::format("yaw {} deg, from the hull as drawn", shown_number(vessel.yaw, "rad", 3)));
  return out + "</div>\n";
}

bool any(const MooredState& state, std::optional<double> MooringLineResult::*member) {
  return std::any_of(state.moorings.begin(), state.moorings.end(),
                     [&](const MooringLineResult& line) { return (line.*member).has_value(); });
}

std::string remark(const MooringLineResult& line) {
  return line.parted ? "parted" : line.slack ? "slack" : line.anchor_uplift > 0.0 ? "lifts its anchor" : "";
}

std::string line_table(const MooredState& state) {
  const bool near = any(state, &MooringLineResult::clearance);
  std::vector<html::Head> head = {{"Line", "", true},
                                  {"Azimuth", shown_name("rad")},
                                  {"Length", shown_name("m")},
                                  {"Suspended", shown_name("m")},
                                  {"On bed", shown_name("m")},
                                  {"Tension", shown_name("N")},
                                  {"Horizontal", shown_name("N")},
                                  {"Declination", shown_name("rad")},
                                  {"Breaking load", "%"},
                                  {"Anchor", shown_name("N")},
                                  {"Uplift angle", shown_name("rad")},
                                  {"Holding power", "%"}};
  if (near) {
    head.push_back({"Clearance", shown_name("m")});
    head.push_back({"to", "", true});
  }
  head.push_back({"", "", true});
  html::Table table("Mooring lines at rest", head, "dense summary");
  for (const MooringLineResult& l : state.moorings) {
    const auto percent = [](const std::optional<double>& use) { return use ? fixed(100.0 * *use, 1) : "-"; };
    std::vector<std::string> cells = {l.name,
                                      shown_number(l.azimuth, "rad", 1),
                                      shown_number(l.length, "m", 2),
                                      shown_number(l.suspended_length, "m", 1),
                                      shown_number(l.on_bed, "m", 1),
                                      shown_number(l.fairlead_tension, "N", 1),
                                      shown_number(l.horizontal, "N", 1),
                                      shown_number(l.declination, "rad", 2),
                                      percent(l.utilisation),
                                      shown_number(l.anchor_tension, "N", 1),
                                      shown_number(l.uplift_angle, "rad", 2),
                                      percent(l.anchor_utilisation)};
    if (l.parted) std::fill(cells.begin() + 3, cells.end(), "-");
    if (near) {
      cells.push_back(length_text(l.clearance, 1));
      cells.push_back(l.nearest_object);
    }
    cells.push_back(remark(l));
    const bool over = l.utilisation.value_or(0.0) > 1.0 || l.anchor_utilisation.value_or(0.0) > 1.0;
    table.row(cells, over ? "over" : l.parted || l.slack ? "soft" : "");
  }
  return table.str() +
         "<p class=\"small\">Azimuth: of the anchor from the fairlead, clockwise from north. Tension, horizontal part "
         "and declination at the fairlead; load and angle over horizontal at the anchor. Lengths are unstressed. "
         "Percentages are of the breaking load and of the anchor's holding power, without safety factors.</p>\n";
}

std::string offset_table(const VesselResult& v) {
  html::Table table("Vessel at rest, from as drawn", {{"", "", true}, {"Value", ""}, {"Unit", "", true}}, "plain");
  table.row({"Surge, forward", shown_number(v.surge, "m", 3), shown_name("m")})
      .row({"Sway, to port", shown_number(v.sway, "m", 3), shown_name("m")})
      .row({"Heave, up", shown_number(v.heave, "m", 4), shown_name("m")})
      .row({"Roll, starboard down", shown_number(v.roll, "rad", 3), shown_name("rad")})
      .row({"Pitch, bow down", shown_number(v.pitch, "rad", 3), shown_name("rad")})
      .row({"Yaw, bow to port", shown_number(v.yaw, "rad", 3), shown_name("rad")});
  return table.str();
}

std::string thrust_table(const std::vector<double>& thrust) {
  if (thrust.size() != 3) return "";
  html::Table table("Dynamic positioning at rest", {{"", "", true}, {"Value", ""}, {"Unit", "", true}}, "plain");
  table.row({"Thrust ahead", shown_number(thrust[0], "N", 1), forces().unit})
      .row({"Thrust to port", shown_number(thrust[1], "N", 1), forces().unit})
      .row({"Moment, bow to port", moments().text(thrust[2], 0), moments().unit});
  return table.str();
}

std::string period_table(const VesselResult& v) {
  if (v.natural_periods.empty()) return "";
  html::Table table("Natural periods at rest, undamped", {{"Mode", "", true}, {"Period", "s"}}, "plain");
  for (const PeriodResult& mode : v.natural_periods) table.row({mode.mode, fixed(mode.period, 2)});
  return table.str();
}

/// Of a force or a moment (rows) by a shift or a turn (columns).
double stiffness_factor(std::size_t row, std::size_t column) {
  return shown_unit("N").factor * std::pow(shown_unit("m").factor, (row < 3 ? 0 : 1) - (column < 3 ? 1 : 0));
}

/// Rotations in radians. Sizes differ by ten thousand.
std::string stiffness_table(const std::vector<double>& stiffness) {
  if (stiffness.size() != 36) return "";
  constexpr std::array<const char*, 6> kFreedoms = {"surge", "sway", "heave", "roll", "pitch", "yaw"};
  std::vector<html::Head> head = {{"", "", true}};
  for (const char* freedom : kFreedoms) head.push_back({freedom, ""});
  const double largest = std::abs(*std::max_element(stiffness.begin(), stiffness.end(),
                                                    [](double a, double b) { return std::abs(a) < std::abs(b); }));
  const std::string units = fmt::format("[{0}/{1}, {0}, {0} {1}]", shown_name("N"), shown_name("m"));
  html::Table table("Stiffness of lines, thrusters and water about midship " + units, head, "plain");
  for (std::size_t i = 0; i < 6; ++i) {
    std::vector<std::string> cells = {kFreedoms[i]};
    for (std::size_t k = 0; k < 6; ++k) {
      const double value = stiffness[6 * i + k];
      cells.push_back(std::abs(value) < 1e-9 * largest ? "0" : fmt::format("{:.5g}", value * stiffness_factor(i, k)));
    }
    table.row(cells);
  }
  return html::folded("Stiffness matrix", table.str());
}

std::string vessel_tables(const MooredState& state) {
  const VesselResult& vessel = state.vessel;
  return "<h3>Vessel</h3>\n<div class=\"columns\">\n" + offset_table(vessel) + thrust_table(state.thrust) +
         period_table(vessel) + "</div>\n" + stiffness_table(vessel.stiffness);
}

const std::vector<Figure>& rest_figures() {
  static const std::vector<Figure> kFigures = {
      {"mooring_plan",
       "Plan of the moorings, north up. Full: hanging part of a line; pale: on the bed; tension at the fairlead",
       {"field"}},
      {"mooring_profile", "Mooring lines in profile, each in its own vertical plane; heights enlarged", {"rest"}},
  };
  return kFigures;
}

std::string figures(const std::vector<Figure>& all, int& figure) {
  return figure_list(
      all, [](const Figure&, const std::string&) { return true; }, figure);
}

}  // namespace

const MooringLineResult* hardest_line(const MooredState& state) {
  const MooringLineResult* hardest = nullptr;
  for (const MooringLineResult& line : state.moorings) {
    if (!line.parted && (hardest == nullptr || line.fairlead_tension > hardest->fairlead_tension)) hardest = &line;
  }
  return hardest;
}

std::string moorings_section(const MooringResults& results, int& figure) {
  const MooredState& rest = results.rest;
  if (rest.moorings.empty()) {
    return html::section("moorings", "Station keeping", tiles(rest) + vessel_tables(rest));
  }
  return html::section("moorings", "Moorings",
                       tiles(rest) + figures(rest_figures(), figure) + line_table(rest) + vessel_tables(rest));
}

}  // namespace overbend
