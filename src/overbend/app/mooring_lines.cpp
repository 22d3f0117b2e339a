#include "app/mooring_lines.h"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "app/warning_lines.h"

namespace overbend {
namespace {

constexpr double kDegrees = 180.0 / std::numbers::pi;

/// A zero of the last digits carries no sign.
double shown(double value) {
  return std::abs(value) < 5e-4 ? 0.0 : value;
}

std::string state_lines(const MooredState& state) {
  const VesselResult& v = state.vessel;
  std::string text = fmt::format(
      "{}\n  hull at surge {:.3f} m, sway {:.3f} m, heave {:.3f} m, roll {:.3f} deg, pitch "
      "{:.3f} deg, yaw {:.3f} deg\n",
      state.name, shown(v.surge), shown(v.sway), shown(v.heave), shown(v.roll * kDegrees), shown(v.pitch * kDegrees),
      shown(v.yaw * kDegrees));
  for (const PeriodResult& period : v.natural_periods) {
    text += fmt::format("  natural period {:<6} {:>9.1f} s\n", period.mode, period.period);
  }
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

std::string mooring_lines(const MooringResults& results) {
  return results.title + "\n" + moored_state_lines(results) + warning_lines(results.warnings);
}

}  // namespace overbend
