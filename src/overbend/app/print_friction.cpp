#include "app/print_friction.h"

#include <fmt/format.h>

#include <cmath>
#include "base/shown_unit.h"

namespace overbend {
namespace {

std::string side(double value, int digits, const char* si) {
  return fmt::format("{:>12} {} to {}", shown_number(std::abs(value), si, digits), shown_name(si),
                     value < 0.0 ? "starboard" : "port");
}

std::string line(const char* name, const std::string& value) {
  return fmt::format("  {:<28}{}\n", name, value);
}

std::string route_lines(const RouteResults& route) {
  std::string text = line("touchdown off the route", side(route.laid_offset, 2, "m"));
  text += line("lateral load on supports", side(route.side_load_supports, 2, "N"));
  text += line("lateral load on seabed", side(route.side_load_bed, 2, "N"));
  if (route.radius <= 0.0) return text;
  text += line(
      "radius of the route",
      fmt::format("{:>12} {}; friction holds a radius of {} or more{}", shown_number(route.radius, "m", 0),
                  shown_name("m"), shown(route.min_stable_radius, "m", 0), route.holds ? "" : ": THE PIPE SLIDES"));
  text += line("lateral sliding",
               fmt::format("{:>12} {} of pipe", shown_number(route.slid_length, "m", 1), shown_name("m")));
  return text;
}

std::string case_line(const RollerFrictionCase& answer) {
  return line(
      ("friction: " + answer.name).c_str(),
      fmt::format(
          "{:>12} {} bottom, lay-back {}, tip {} to port{}, overbend {}, sagbend {}",
          shown_number(answer.bottom_tension, "N", 2), shown_name("N"), shown(answer.lay_back, "m", 2),
          shown(answer.tip_side, "m", 3),
          answer.off_roller > 0.0 ? " (" + shown(answer.off_roller, section_length(), 0) + " off its roller)" : "",
          shown(answer.overbend_stress, "Pa", 1), shown(answer.sagbend_stress, "Pa", 1)));
}

}  // namespace

std::string friction_lines(const StaticResults& results) {
  std::string text;
  if (results.route) text += route_lines(*results.route);
  for (const RollerFrictionCase& answer : results.roller_friction) text += case_line(answer);
  return text;
}

}  // namespace overbend
