#include "app/print_moorings.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/shown_unit.h"
#include "results/tables/mooring_tables.h"

namespace overbend {
namespace {

std::string state_lines(const MooredState& state) {
  const VesselResult& v = state.vessel;
  std::string text = fmt::format("{}\n  hull at surge {}, sway {}, heave {}, roll {}, pitch {}, yaw {}\n", state.name,
                                 shown(v.surge, "m", 3), shown(v.sway, "m", 3), shown(v.heave, "m", 3),
                                 shown(v.roll, "rad", 3), shown(v.pitch, "rad", 3), shown(v.yaw, "rad", 3));
  for (const PeriodResult& period : v.natural_periods) {
    text += fmt::format("  natural period {:<6} {:>9.1f} s\n", period.mode, period.period);
  }
  if (!state.thrust.empty()) {
    text += fmt::format("  thrust ahead {}, to port {}, bow to port {}\n", shown(state.thrust[0], "N", 1),
                        shown(state.thrust[1], "N", 1), shown(state.thrust[2], "N m", 1));
  }
  return text +
         table_text(moorings_at_rest(state.moorings)
                        .with_columns({"name", "fairlead_tension", "length", "on_bed", "anchor_tension", "utilisation",
                                       "anchor_utilisation", "clearance", "nearest_object", "remark"}));
}

}  // namespace

std::string moored_state_lines(const MooringResults& results) {
  std::string text = state_lines(results.rest);
  for (const MooredState& stage : results.stages) text += state_lines(stage);
  for (const WinchMove& move : results.winches) {
    const double paid_out = move.after - move.before;
    text += fmt::format("  winch of {:<16}{:>9} {}\n", move.name,
                        (std::signbit(paid_out) ? "" : "+") + shown_number(paid_out, "m", 3), shown_name("m"));
  }
  return text;
}

std::string hull_lines(const HullResults& hull) {
  double damping = 0.0, mass = 0.0, min_damping = 0.0;
  for (const RadiationEntryResult& entry : hull.entries) {
    damping = std::max(damping, entry.damping_error);
    mass = std::max(mass, entry.mass_error);
  }
  for (const RadiationGroupResult& group : hull.groups) min_damping = std::min(min_damping, group.min_fitted_damping);
  std::string text = fmt::format(
      "  radiation: {} states, maximum errors {:.2f} % (damping) and {:.2f} % (added mass), minimum eigenvalue "
      "{:.1e}\n",
      hull.states, 100.0 * damping, 100.0 * mass, min_damping);
  for (const ModeDampingResult& mode : hull.damping) {
    text += fmt::format(
        "  LF {:<6} uncoupled period {:.1f} s, damping {:.2f} % of critical: radiation {:.2f}, drift {:.2f}, current "
        "{:.2f}, "
        "viscous {:.2f}",
        mode.mode, mode.period, 100.0 * mode.total, 100.0 * mode.radiation, 100.0 * mode.drift, 100.0 * mode.current,
        100.0 * mode.viscous);
    if (mode.station_keeping != 0.0) text += fmt::format(", DP {:.2f}", 100.0 * mode.station_keeping);
    text += "\n";
  }
  return text;
}

namespace {

/// Returns the columns of the statistics that fit on a terminal.
Table narrow(const Table& statistics) {
  return statistics.with_columns({"name", "unit", "mean", "slow_std", "wave_std", "min", "max", "most_probable_max"});
}

}  // namespace

std::string moored_dynamics_lines(const DynamicResults& results) {
  std::string text;
  const auto add = [&](const Table& table) {
    if (!table.empty()) text += "  " + table.title + "\n" + table_text(table, 4);
  };
  if (results.vessel) {
    add(narrow(vessel_motions(*results.vessel, course(results))));
    text += "  " + results.vessel->confidence + "\n";
  }
  add(thrust_over_time(results.thrust));
  add(narrow(fairlead_tensions(results.moorings)));
  return text;
}

}  // namespace overbend
