#include "app/mooring_lines.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "app/check_lines.h"
#include "app/finding_lines.h"
#include "base/constants.h"

namespace overbend {
namespace {

/// A zero of the last digits carries no sign.
double shown(double value) {
  return std::abs(value) < 5e-4 ? 0.0 : value;
}

std::string state_lines(const MooredState& state) {
  const VesselResult& v = state.vessel;
  std::string text = fmt::format(
      "{}\n  hull at surge {:.3f} m, sway {:.3f} m, heave {:.3f} m, roll {:.3f} deg, pitch "
      "{:.3f} deg, yaw {:.3f} deg\n",
      state.name, shown(v.surge), shown(v.sway), shown(v.heave), shown(v.roll * kToDegrees),
      shown(v.pitch * kToDegrees), shown(v.yaw * kToDegrees));
  for (const PeriodResult& period : v.natural_periods) {
    text += fmt::format("  natural period {:<6} {:>9.1f} s\n", period.mode, period.period);
  }
  if (!state.thrust.empty()) {
    text += fmt::format("  thrust ahead {:.1f} kN, to port {:.1f} kN, bow to port {:.1f} kN m\n",
                        shown(1e-3 * state.thrust[0]), shown(1e-3 * state.thrust[1]), shown(1e-3 * state.thrust[2]));
  }
  if (state.moorings.empty()) return text;
  text += fmt::format("  {:<16}{:>12}{:>12}{:>12}{:>12}{:>12}\n", "line", "tension kN", "length m", "on bed m",
                      "anchor kN", "of MBL");
  for (const MooringLineResult& line : state.moorings) {
    const std::string used = line.utilisation ? fmt::format("{:.3f}", *line.utilisation) : "-";
    text += line.parted
                ? fmt::format("  {:<16}{:>12}\n", line.name, "parted")
                : fmt::format("  {:<16}{:>12.2f}{:>12.3f}{:>12.1f}{:>12.2f}{:>12}\n", line.name,
                              line.fairlead_tension / 1e3, line.length, line.on_bed, line.anchor_tension / 1e3, used);
  }
  return text;
}

}  // namespace

std::string moored_state_lines(const MooringResults& results) {
  std::string text = state_lines(results.rest);
  for (const MooredState& stage : results.stages) text += state_lines(stage);
  for (const WinchMove& move : results.winches) {
    text += fmt::format("  winch of {:<16}{:>+9.3f} m\n", move.name, move.after - move.before);
  }
  return text;
}

std::string hull_lines(const HullResults& hull) {
  double damping = 0.0, mass = 0.0, least = 0.0;
  for (const RadiationEntryResult& entry : hull.entries) {
    damping = std::max(damping, entry.damping_error);
    mass = std::max(mass, entry.mass_error);
  }
  for (const RadiationGroupResult& group : hull.groups) least = std::min(least, group.least_damping);
  std::string text = fmt::format(
      "  radiation: {} numbers of memory, largest errors {:.2f} % (damping) and {:.2f} % (added mass), least "
      "eigenvalue "
      "{:.1e}\n",
      hull.states, 100.0 * damping, 100.0 * mass, least);
  for (const ModeDampingResult& mode : hull.damping) {
    text += fmt::format(
        "  slow {:<6} {:>9.1f} s alone, damping {:.2f} % of critical: radiation {:.2f}, drift {:.2f}, current {:.2f}, "
        "viscous {:.2f}",
        mode.mode, mode.period, 100.0 * mode.total, 100.0 * mode.radiation, 100.0 * mode.drift, 100.0 * mode.current,
        100.0 * mode.viscous);
    if (mode.station_keeping != 0.0) text += fmt::format(", positioning {:.2f}", 100.0 * mode.station_keeping);
    text += "\n";
  }
  return text;
}

namespace {

std::string in_three_hours(const MotionSpread& motion, double factor, int digits) {
  return motion.most_probable_max ? fmt::format("{:.{}f}", *motion.most_probable_max * factor, digits) : "none";
}

}  // namespace

std::string moored_dynamics_lines(const DynamicResults& results) {
  std::string text;
  if (results.vessel) {
    const VesselDynamics& v = *results.vessel;
    text += fmt::format("  {:<16}{:>12}{:>12}{:>12}{:>12}{:>12}{:>12}\n", "vessel", "mean", "slow std", "wave std",
                        "min", "max", "in 3 h");
    const auto row = [&](const char* name, const MotionSpread& m, double factor) {
      text += fmt::format("  {:<16}{:>12.3f}{:>12.3f}{:>12.3f}{:>12.3f}{:>12.3f}{:>12}\n", name,
                          shown(m.whole.mean * factor), m.slow.std * factor, m.wave.std * factor, m.whole.min * factor,
                          m.whole.max * factor, in_three_hours(m, factor, 3));
    };
    row("surge m", v.surge, 1.0);
    row("sway m", v.sway, 1.0);
    row("heave m", v.heave, 1.0);
    row("roll deg", v.roll, kToDegrees);
    row("pitch deg", v.pitch, kToDegrees);
    row("yaw deg", v.yaw, kToDegrees);
    row("offset m", v.offset, 1.0);
    text += "  " + v.confidence + "\n";
  }
  if (!results.thrust.empty()) {
    text += fmt::format("  {:<16}{:>12}{:>12}{:>12}{:>12}{:>12}{:>12}\n", "thrust kN, kN m", "mean", "std", "min",
                        "max", "limit", "s at limit");
    for (const ThrustDynamics& one : results.thrust) {
      text += fmt::format("  {:<16}{:>12.1f}{:>12.1f}{:>12.1f}{:>12.1f}{:>12}{:>12.1f}\n", one.name,
                          shown(1e-3 * one.given.mean), 1e-3 * one.given.std, shown(1e-3 * one.given.min),
                          shown(1e-3 * one.given.max), one.limit ? fmt::format("{:.1f}", 1e-3 * *one.limit) : "none",
                          one.time_at_limit);
    }
  }
  if (results.moorings.empty()) return text;
  text += fmt::format("  {:<16}{:>12}{:>12}{:>12}{:>12}{:>12}{:>12}\n", "line tension kN", "mean", "slow std",
                      "wave std", "min", "max", "in 3 h");
  for (const MooringLineDynamics& line : results.moorings) {
    const MotionSpread& t = line.fairlead_tension;
    text += fmt::format("  {:<16}{:>12.1f}{:>12.1f}{:>12.1f}{:>12.1f}{:>12.1f}{:>12}\n", line.name, 1e-3 * t.whole.mean,
                        1e-3 * t.slow.std, 1e-3 * t.wave.std, 1e-3 * t.whole.min, 1e-3 * t.whole.max,
                        in_three_hours(t, 1e-3, 1));
  }
  return text;
}

std::string mooring_lines(const MooringResults& results) {
  return results.title + "\n" + moored_state_lines(results) + (results.hull ? hull_lines(*results.hull) : "") +
         check_lines(results.checks) + verdict_line(results.checks, results.findings) + finding_lines(results.findings);
}

}  // namespace overbend
