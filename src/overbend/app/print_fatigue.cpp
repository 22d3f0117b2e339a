#include "app/print_fatigue.h"

#include <fmt/format.h>

#include "base/shown_unit.h"
#include "base/text.h"

namespace overbend {
namespace {

std::string duration_label(double seconds) {
  if (seconds < 7200.0) return fmt::format("{:.0f} min", seconds / 60.0);
  if (seconds < 10.0 * 86400.0) return fmt::format("{:.1f} h", seconds / 3600.0);
  return seconds < 730.0 * 86400.0 ? fmt::format("{:.0f} days", seconds / 86400.0)
                                   : fmt::format("{:.0f} years", seconds / 31557600.0);
}

}  // namespace

std::string fatigue_lines(const DynamicResults& results) {
  std::string lines;
  if (!results.fatigue) return lines;
  for (const FatigueSpot& spot : results.fatigue->spots) {
    lines += fmt::format(
        "  {:<28}{:>12} of standby, damage on the lay path {:.2g}, {:.2g} per hour {} from the "
        "tensioner\n",
        "fatigue '" + for_display(spot.name, 14) + "'", duration_label(spot.standby), spot.path_damage,
        3600.0 * spot.worst_rate, shown(results.station_s.back() - spot.worst_s, "m", 1));
  }
  return lines;
}

}  // namespace overbend
