#include "app/print_lines_and_bodies.h"

#include <fmt/format.h>

#include "base/shown_unit.h"

namespace overbend {
namespace {

std::string end_line(const char* name, const LineEndResult& end, const SummaryStatistics* in_time) {
  std::string text = fmt::format("    {:<26}{:>12} {}", name, shown_number(end.tension, "N", 2), shown_name("N"));
  if (in_time != nullptr) {
    text += fmt::format(", {} to {}", shown_number(in_time->min, "N", 2), shown(in_time->max, "N", 2));
  }
  return text + "\n";
}

/// Returns the text of a line; `in_time` is null without a run.
std::string line_text(const LineResult& line, const LineDynamics* in_time) {
  std::string text = fmt::format("  {}: {}, {} element{}, {} on the seabed\n", line.name, shown(line.length, "m", 2),
                                 line.elements, line.elements == 1 ? "" : "s", shown(line.on_bed, "m", 1));
  text += end_line("first end", line.first, in_time != nullptr ? &in_time->first_tension : nullptr);
  text += end_line("second end", line.second, in_time != nullptr ? &in_time->second_tension : nullptr);
  if (!line.utilisation) return text;
  text += fmt::format("    {:<26}{:>12.3f}", "of the breaking load", *line.utilisation);
  if (in_time != nullptr) {
    text += fmt::format(" static, {:.3f} maximum", in_time->utilisation.value_or(*line.utilisation));
  }
  return text + "\n";
}

/// Returns the distance from the tensioner, and height and bending moment of the pipe at this point.
std::string place_text(const AttachedPlace& place) {
  return fmt::format("{} from the tensioner, z = {}, bending moment {}", shown(place.from_top, "m", 1),
                     shown(place.p_W.z(), "m", 1), shown(place.moment, "N m", 1));
}

std::string body_text(const BodyResult& body) {
  std::string text = fmt::format("  {}: at {} east, {} north, heading {}\n", body.name, shown(body.place.x(), "m", 2),
                                 shown(body.place.y(), "m", 2), shown(body.heading, "rad", 2));
  if (body.floats) {
    text += fmt::format("    {:<26}{} ahead, {} to port, {} up; roll {}, pitch {}, yaw {}\n", "offset from nominal",
                        shown(body.surge, "m", 3), shown(body.sway, "m", 3), shown(body.heave, "m", 3),
                        shown(body.roll, "rad", 3), shown(body.pitch, "rad", 3), shown(body.yaw, "rad", 3));
  }
  return text + fmt::format("    {:<26}{:>12} {} horizontally, {} upwards\n", "force of lines",
                            shown_number(body.force.head<2>().norm(), "N", 2), shown_name("N"),
                            shown(body.force.z(), "N", 2));
}

}  // namespace

std::string attachment_lines(const StaticResults& results) {
  std::string text;
  for (const PipePointResult& point : results.points) {
    text += fmt::format("  {:<28}{:>12} {} upwards, {}\n", point.name, shown_number(point.force.z(), "N", 2),
                        shown_name("N"), place_text(point.location));
  }
  for (const PipeWireResult& wire : results.wires) {
    const std::string used =
        wire.utilisation ? fmt::format(", {:.3f} of the breaking load", *wire.utilisation) : std::string();
    text += fmt::format("  {:<28}{:>12} {}{}, {}\n", wire.name, shown_number(wire.tension_upper, "N", 2),
                        shown_name("N"), used, place_text(wire.location));
  }
  return text;
}

std::string bodies_at_rest(const std::vector<BodyResult>& bodies) {
  std::string text;
  for (const BodyResult& body : bodies) text += body_text(body);
  return text;
}

std::string bodies_in_time(const std::vector<BodyDynamics>& bodies) {
  std::string text;
  for (const BodyDynamics& body : bodies) {
    text +=
        fmt::format("  {}: horizontal force of lines {} to {}, mean {}\n", body.name,
                    shown_number(body.pull.min, "N", 2), shown(body.pull.max, "N", 2), shown(body.pull.mean, "N", 2));
  }
  return text;
}

std::string lines_at_rest_text(const std::vector<LineResult>& lines) {
  std::string text;
  for (const LineResult& line : lines) text += line_text(line, nullptr);
  return text;
}

std::string lines_in_time(const std::vector<LineResult>& lines, const std::vector<LineDynamics>& in_time) {
  std::string text;
  for (std::size_t i = 0; i < lines.size(); ++i) text += line_text(lines[i], &in_time.at(i));
  return text;
}

}  // namespace overbend
