#include "report/moorings_section.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/constants.h"
#include "report/figure_list.h"
#include "report/html.h"
#include "report/quantity.h"

namespace overbend {
namespace {

using html::fixed;
using html::tile;

std::string kilo(double newton, int digits = 1) {
  return forces().text(newton, digits);
}

std::string optional_text(const std::optional<double>& value, int digits) {
  return value ? fixed(*value, digits) : "-";
}

std::string use_note(const MooringLineResult& line) {
  return line.utilisation ? line.name + ", " + fixed(100.0 * *line.utilisation, 1) + " % of its breaking load"
                          : line.name;
}

std::string tiles(const MooredState& state) {
  std::string out = "<div class=\"tiles\">\n";
  if (const MooringLineResult* hardest = hardest_line(state)) {
    out += tile("Largest line tension", kilo(hardest->fairlead_tension), forces().unit, use_note(*hardest),
                hardest->utilisation.value_or(0.0) > 1.0);
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
    out += tile("Largest anchor load", kilo(anchor->anchor_tension), forces().unit,
                anchor->name + (use ? ", " + fixed(100.0 * *use, 1) + " % of its holding power" : ""),
                use.value_or(0.0) > 1.0);
    out += tile("Least length on the bed", fixed(shortest->on_bed, 1), "m", shortest->name, shortest->on_bed <= 0.0);
  }
  const VesselResult& vessel = state.vessel;
  out += tile("Offset of midship", fixed(std::hypot(vessel.surge, vessel.sway), 3), "m",
              fmt::format("yaw {} deg, from the hull as drawn", fixed(vessel.yaw * kToDegrees, 3)));
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
  std::vector<html::Head> head = {{"Line", "", true},   {"Azimuth", "deg"},      {"Length", "m"},
                                  {"Suspended", "m"},   {"On bed", "m"},         {"Tension", "kN"},
                                  {"Horizontal", "kN"}, {"Declination", "deg"},  {"Breaking load", "%"},
                                  {"Anchor", "kN"},     {"Uplift angle", "deg"}, {"Holding power", "%"}};
  if (near) {
    head.push_back({"Clearance", "m"});
    head.push_back({"to", "", true});
  }
  head.push_back({"", "", true});
  html::Table table("Mooring lines at rest", head, "dense summary");
  for (const MooringLineResult& l : state.moorings) {
    const auto percent = [](const std::optional<double>& use) { return use ? fixed(100.0 * *use, 1) : "-"; };
    std::vector<std::string> cells = {l.name,
                                      fixed(l.azimuth * kToDegrees, 1),
                                      fixed(l.length, 2),
                                      fixed(l.suspended_length, 1),
                                      fixed(l.on_bed, 1),
                                      kilo(l.fairlead_tension),
                                      kilo(l.horizontal),
                                      fixed(l.declination * kToDegrees, 2),
                                      percent(l.utilisation),
                                      kilo(l.anchor_tension),
                                      fixed(l.uplift_angle * kToDegrees, 2),
                                      percent(l.anchor_utilisation)};
    if (l.parted) std::fill(cells.begin() + 3, cells.end(), "-");
    if (near) {
      cells.push_back(optional_text(l.clearance, 1));
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
  table.row({"Surge, forward", fixed(v.surge, 3), "m"})
      .row({"Sway, to port", fixed(v.sway, 3), "m"})
      .row({"Heave, up", fixed(v.heave, 4), "m"})
      .row({"Roll, starboard down", fixed(v.roll * kToDegrees, 3), "deg"})
      .row({"Pitch, bow down", fixed(v.pitch * kToDegrees, 3), "deg"})
      .row({"Yaw, bow to port", fixed(v.yaw * kToDegrees, 3), "deg"});
  return table.str();
}

std::string thrust_table(const std::vector<double>& thrust) {
  if (thrust.size() != 3) return "";
  html::Table table("Dynamic positioning at rest", {{"", "", true}, {"Value", ""}, {"Unit", "", true}}, "plain");
  table.row({"Thrust ahead", kilo(thrust[0]), forces().unit})
      .row({"Thrust to port", kilo(thrust[1]), forces().unit})
      .row({"Moment, bow to port", moments().text(thrust[2], 0), moments().unit});
  return table.str();
}

std::string period_table(const VesselResult& v) {
  if (v.natural_periods.empty()) return "";
  html::Table table("Natural periods at rest, undamped", {{"Mode", "", true}, {"Period", "s"}}, "plain");
  for (const PeriodResult& mode : v.natural_periods) table.row({mode.mode, fixed(mode.period, 2)});
  return table.str();
}

/// In kN and m; rotations in radians. Sizes differ by ten thousand.
std::string stiffness_table(const std::vector<double>& stiffness) {
  if (stiffness.size() != 36) return "";
  constexpr std::array<const char*, 6> kFreedoms = {"surge", "sway", "heave", "roll", "pitch", "yaw"};
  std::vector<html::Head> head = {{"", "", true}};
  for (const char* freedom : kFreedoms) head.push_back({freedom, ""});
  const double largest = std::abs(*std::max_element(stiffness.begin(), stiffness.end(),
                                                    [](double a, double b) { return std::abs(a) < std::abs(b); }));
  html::Table table("Stiffness of lines, thrusters and water about midship [kN/m, kN, kN m]", head, "plain");
  for (std::size_t i = 0; i < 6; ++i) {
    std::vector<std::string> cells = {kFreedoms[i]};
    for (std::size_t k = 0; k < 6; ++k) {
      const double value = stiffness[6 * i + k];
      cells.push_back(std::abs(value) < 1e-9 * largest ? "0" : fmt::format("{:.5g}", 1e-3 * value));
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
