#include "report/moored/hull_section.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace overbend {
namespace {

std::string four_digits(double value) {
  return value == 0.0 ? "0" : fmt::format("{:.4g}", value);
}

bool turns(const std::string& mode) {
  return mode == "roll" || mode == "pitch" || mode == "yaw";
}

std::string critical_units() {
  return fmt::format("{0} s/{1}, {0} {1} s", shown_name("N"), shown_name("m"));
}

double critical_factor(const std::string& mode) {
  return shown_unit("N").factor * std::pow(shown_unit("m").factor, turns(mode) ? 1 : -1);
}

std::string added_mass_units() {
  return fmt::format("{0}, {0} {1}, {0} {1}2", shown_name("kg"), shown_name("m"));
}

/// The share of dynamic positioning has a column only if there is any.
Blocks damping_table(const std::vector<ModeDampingResult>& modes) {
  if (modes.empty()) return {};
  const bool positioned = std::any_of(modes.begin(), modes.end(),
                                      [](const ModeDampingResult& mode) { return mode.station_keeping != 0.0; });
  Table table{"Damping of the low-frequency motions, shares of critical damping",
              {TableColumn("Mode"),
               {"Natural period", "s", 2},
               TableColumn::texts("Critical", critical_units()),
               {"Radiation", "%", 2},
               {"of the file", "%", 2},
               {"Wave drift", "%", 2},
               {"Current", "%", 2},
               {"Viscous", "%", 2},
               {"Positioning", "%", 2},
               {"Sum", "%", 2}},
              "full summary"};
  for (const ModeDampingResult& mode : modes) {
    table.row({mode.mode, mode.period, four_digits(mode.critical * critical_factor(mode.mode)), 100.0 * mode.radiation,
               100.0 * mode.radiation_file, 100.0 * mode.drift, 100.0 * mode.current, 100.0 * mode.viscous,
               positioned ? TableCell(100.0 * mode.station_keeping) : TableCell(), 100.0 * mode.total},
              mode.total < 0.0 ? RowMark::over : RowMark::none);
  }
  return Blocks(table.drop_empty_columns()) +
         block::remark(
             "Each mode alone on the stiffness of the moorings. Radiation: from the fitted radiation memory, "
             "followed by that of the hydrodynamic file at the same period. The additional damping by drag of the "
             "mooring lines and seabed friction is not included.");
}

Table load_table(const HullResults& hull) {
  Table table{"Steady loads on the hull, along its axes",
              {TableColumn(""), {"Forward", "N", 1}, {"To port", "N", 1}, {"Bow to port", "N m", 0}}};
  const auto add = [&](const char* name, const SteadyLoad& load) {
    if (load.surge != 0.0 || load.sway != 0.0 || load.yaw != 0.0) table.row({name, load.surge, load.sway, load.yaw});
  };
  add("Mean wave drift", hull.drift);
  add("Current", hull.current);
  add("Wind", hull.wind);
  return table;
}

Blocks sensitivity_table(const HullResults& hull) {
  if (hull.min_current_force == 0.0 && hull.max_current_force == 0.0) return {};
  Table table{"Transverse current on the hull: effect of the drag coefficient",
              {TableColumn("Transverse drag coefficient"), {"Force to port", "N", 1}}};
  return table.row({"0.44, a barge in deep water by UFC 4-159-03", hull.min_current_force})
      .row({"as in the model", hull.current.sway}, RowMark::total)
      .row({"1.2, sharp edges in two dimensions", hull.max_current_force});
}

Table group_table(const HullResults& hull) {
  Table table{"Radiation memory, by group of modes",
              {TableColumn("Modes"),
               TableColumn("Method"),
               {"Order", "", 0},
               TableColumn::texts("Min. eigenvalue of B"),
               {"at", ShownUnit{"rad/s", "rad/s"}, 3},
               TableColumn::texts("Damping added", "of largest B")}};
  for (const RadiationGroupResult& group : hull.groups) {
    table.row({group.modes, group.method, group.order > 0 ? TableCell(group.order) : "-",
               fmt::format("{:.1e}", group.min_fitted_damping), group.min_fitted_damping_omega,
               group.added_damping > 0.0 ? fmt::format("{:.1e}", group.added_damping) : "none"});
  }
  return table;
}

Table entry_table(const HullResults& hull) {
  Table table{"Fit to the hydrodynamic file, by pair of modes",
              {TableColumn("Modes"),
               {"Error of B", "%", 2},
               {"Error of A", "%", 2},
               TableColumn::texts("A\u221e of the file", added_mass_units()),
               TableColumn::texts("A\u221e in use", added_mass_units()),
               {"difference", "%", 2},
               {"Tail exponent", "", 2}}};
  for (const RadiationEntryResult& entry : hull.entries) {
    const bool known = entry.added_mass_file != 0.0;
    const double factor =
        shown_unit("kg").factor * std::pow(shown_unit("m").factor, int{turns(entry.first)} + int{turns(entry.second)});
    table.row({entry.first == entry.second ? entry.first : entry.first + ", " + entry.second,
               100.0 * entry.damping_error, 100.0 * entry.mass_error, four_digits(factor * entry.added_mass_file),
               four_digits(factor * entry.added_mass_used),
               known ? TableCell(100.0 * (entry.added_mass_used / entry.added_mass_file - 1.0)) : "-",
               entry.tail_exponent});
  }
  return table;
}

Blocks fit_part(const HullResults& hull) {
  if (hull.entries.empty()) return {};
  Blocks part = block::subheading("Radiation") + group_table(hull) + entry_table(hull);
  part += block::remark(fmt::format(
      "Errors: maxima over the frequencies of the file, relative to the maximum value. The radiation memory has {} "
      "states. A negative eigenvalue of the fitted damping would feed energy into the hull; it is compensated by "
      "the added damping. A\u221e in use is consistent with the retardation functions.",
      hull.states));
  if (hull.below_table > 0.0 || hull.above_table > 0.0) {
    part += block::remark(
        fmt::format("Of the sea's variance, {} % lies below and {} % above the frequencies of the wave forces.",
                    fixed(100.0 * hull.below_table, 3), fixed(100.0 * hull.above_table, 3)));
  }
  return part;
}

}  // namespace

Blocks hull_section(const HullResults& hull) {
  return block::section(
      "hull", "Hull",
      damping_table(hull.damping) + block::columns(load_table(hull) + sensitivity_table(hull)) + fit_part(hull));
}

}  // namespace overbend
