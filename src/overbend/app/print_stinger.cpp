#include "app/print_stinger.h"

#include <fmt/format.h>

#include <cmath>

#include "base/shown_unit.h"
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
    lines += fmt::format("  {:<28}{:>12} deg, hinge force {}", heading(section), shown_number(section.angle, "rad", 2),
                         shown(section.hinge_force, "N", 1));
    if (section.at_stop) lines += ", at a stop with " + shown(std::abs(section.stop_moment), "N m", 0);
    if (!section.floats) lines += ", held with " + shown(std::abs(section.stop_moment), "N m", 0);
    if (section.floats && section.friction_moment > 0.0) {
      lines += fmt::format(", {} to {} with friction of the hinge", shown_number(section.angle_up, "rad", 2),
                           shown(section.angle_down, "rad", 2));
    }
    if (section.natural_period > 0.0) lines += fmt::format(", period {:.1f} s", section.natural_period);
    lines += "\n";
  }
  return lines;
}

}  // namespace overbend
