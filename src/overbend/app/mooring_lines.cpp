#include "app/mooring_lines.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/shown_unit.h"

namespace overbend {
namespace {

/// "tension kN"
std::string in(const char* name, std::string_view si) {
  return std::string(name) + " " + shown_name(si);
}

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
  if (state.moorings.empty()) return text;
  text += fmt::format("  {:<16}{:>12}{:>12}{:>12}{:>12}{:>12}\n", "line", in("tension", "N"), in("length", "m"),
                      in("on bed", "m"), in("anchor", "N"), "of MBL");
  for (const MooringLineResult& line : state.moorings) {
    const std::string used = line.utilisation ? fmt::format("{:.3f}", *line.utilisation) : "-";
    text += line.parted
                ? fmt::format("  {:<16}{:>12}\n", line.name, "parted")
                : fmt::format("  {:<16}{:>12}{:>12}{:>12}{:>12}{:>12}\n", line.name,
                              shown_number(line.fairlead_tension, "N", 2), shown_number(line.length, "m", 3),
                              shown_number(line.on_bed, "m", 1), shown_number(line.anchor_tension, "N", 2), used);
  }
  return text;
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

std::string in_three_hours(const MotionSpread& motion, std::string_view si, int digits) {
  return motion.most_probable_max ? shown_number(*motion.most_probable_max, si, digits) : "none";
}

}  // namespace

std::string moored_dynamics_lines(const DynamicResults& results) {
  std::string text;
  if (results.vessel) {
    const VesselDynamics& v = *results.vessel;
    text += fmt::format("  {:<16}{:>12}{:>12}{:>12}{:>12}{:>12}{:>12}\n", "vessel", "mean", "slow std", "wave std",
                        "min", "max", "in 3 h");
    const auto row = [&](const char* name, const MotionSpread& m, std::string_view si) {
      const auto cell = [&](double value) { return shown_number(value, si, 3); };
      text += fmt::format("  {:<16}{:>12}{:>12}{:>12}{:>12}{:>12}{:>12}\n", in(name, si), cell(m.whole.mean),
                          cell(m.slow.std), cell(m.wave.std), cell(m.whole.min), cell(m.whole.max),
                          in_three_hours(m, si, 3));
    };
    row("surge", v.surge, "m");
    row("sway", v.sway, "m");
    row("heave", v.heave, "m");
    row("roll", v.roll, "rad");
    row("pitch", v.pitch, "rad");
    row("yaw", v.yaw, "rad");
    row("offset", v.offset, "m");
    text += "  " + v.confidence + "\n";
  }
  if (!results.thrust.empty()) {
    text += fmt::format("  {:<16}{:>12}{:>12}{:>12}{:>12}{:>12}{:>12}\n",
                        "thrust " + shown_name("N") + ", " + shown_name("N m"), "mean", "std", "min", "max", "limit",
                        "s at limit");
    for (const ThrustDynamics& one : results.thrust) {
      const char* si = &one - results.thrust.data() == 2 ? "N m" : "N";
      const auto cell = [&](double value) { return shown_number(value, si, 1); };
      text += fmt::format("  {:<16}{:>12}{:>12}{:>12}{:>12}{:>12}{:>12.1f}\n", one.name, cell(one.given.mean),
                          cell(one.given.std), cell(one.given.min), cell(one.given.max),
                          one.limit ? cell(*one.limit) : "none", one.time_at_limit);
    }
  }
  if (results.moorings.empty()) return text;
  text += fmt::format("  {:<16}{:>12}{:>12}{:>12}{:>12}{:>12}{:>12}\n", in("line tension", "N"), "mean", "slow std",
                      "wave std", "min", "max", "in 3 h");
  for (const MooringLineDynamics& line : results.moorings) {
    const MotionSpread& t = line.fairlead_tension;
    const auto cell = [](double value) { return shown_number(value, "N", 1); };
    text +=
        fmt::format("  {:<16}{:>12}{:>12}{:>12}{:>12}{:>12}{:>12}\n", line.name, cell(t.whole.mean), cell(t.slow.std),
                    cell(t.wave.std), cell(t.whole.min), cell(t.whole.max), in_three_hours(t, "N", 1));
  }
  return text;
}

}  // namespace overbend
