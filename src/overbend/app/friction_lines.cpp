#include "app/friction_lines.h"

#include <fmt/format.h>

#include <cmath>

namespace overbend {
namespace {

std::string side(double value, int digits, const char* unit) {
  return fmt::format("{:>12.{}f} {} to {}", std::abs(value), digits, unit, value < 0.0 ? "starboard" : "port");
}

std::string line(const char* name, const std::string& value) {
  return fmt::format("  {:<28}{}\n", name, value);
}

std::string route_lines(const RouteResults& route) {
  std::string text = line("touchdown beside the route", side(route.laid_offset, 2, "m"));
  text += line("side load on the supports", side(route.side_load_supports / 1e3, 2, "kN"));
  text += line("side load on the seabed", side(route.side_load_bed / 1e3, 2, "kN"));
  if (route.radius <= 0.0) return text;
  text += line("radius of the route", fmt::format("{:>12.0f} m; friction holds {:.0f} m and more{}", route.radius,
                                                  route.least_radius, route.holds ? "" : ": THE PIPE SLIDES"));
  text += line("slid sideways", fmt::format("{:>12.1f} m of pipe", route.slid_length));
  return text;
}

std::string case_line(const RollerFrictionCase& answer) {
  return line(
      ("friction: " + answer.name).c_str(),
      fmt::format("{:>12.2f} kN bottom, lay-back {:.2f} m, tip {:.3f} m to port{}, overbend {:.1f} MPa, "
                  "sagbend {:.1f} MPa",
                  answer.bottom_tension / 1e3, answer.lay_back, answer.tip_side,
                  answer.off_roller > 0.0 ? fmt::format(" ({:.0f} mm off its roller)", 1e3 * answer.off_roller) : "",
                  answer.overbend_stress / 1e6, answer.sagbend_stress / 1e6));
}

}  // namespace

std::string friction_lines(const StaticResults& results) {
  std::string text;
  if (results.route) text += route_lines(*results.route);
  for (const RollerFrictionCase& answer : results.roller_friction) text += case_line(answer);
  return text;
}

}  // namespace overbend
