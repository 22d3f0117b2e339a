#include "app/stinger_lines.h"

#include <fmt/format.h>

#include <cmath>

#include "base/constants.h"
#include "base/text.h"

namespace overbend {
namespace {

std::string heading(const StingerSectionResult& section) {
  return section.name.empty() ? "stinger angle" : "angle of '" + for_display(section.name, 16) + "'";
}

}  // namespace

std::string stinger_lines(const StaticResults& results) {
  std::string lines;
  for (const StingerSectionResult& section : results.stinger) {
    lines += fmt::format("  {:<28}{:>12.2f} deg, hinge force {:.1f} kN", heading(section), section.angle * kToDegrees,
                         section.hinge_force / 1e3);
    if (section.at_stop) lines += fmt::format(", at a stop with {:.0f} kN m", std::abs(section.stop_moment) / 1e3);
    if (!section.floats) lines += fmt::format(", held with {:.0f} kN m", std::abs(section.stop_moment) / 1e3);
    if (section.floats && section.friction_moment > 0.0) {
      lines += fmt::format(", {:.2f} to {:.2f} deg with friction of the hinge", section.angle_up * kToDegrees,
                           section.angle_down * kToDegrees);
    }
    if (section.natural_period > 0.0) lines += fmt::format(", period {:.1f} s", section.natural_period);
    lines += "\n";
  }
  return lines;
}

}  // namespace overbend
