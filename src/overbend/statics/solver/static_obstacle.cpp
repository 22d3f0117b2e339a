#include "statics/solver/static_obstacle.h"

#include "model/lay_stage.h"
#include "model/pipe_attachments.h"
#include "model/vessel/station.h"
#include "statics/solver/static_start.h"

namespace overbend {
namespace {

StaticFailure obstacle(const char* key, const char* what, const char* why) {
  return {what, "", why, true, key};
}

std::optional<StaticFailure> bent_route_obstacle(const Description& description) {
  if (has_cable(description)) {
    return obstacle("route", "a line with a cable on a route that bends cannot be solved yet", "leave out route");
  }
  if (wanted_of(description).kind == EquilibriumTarget::Kind::anchor_distance) {
    return obstacle("pipe.anchor", "an anchor's distance on a route that bends cannot be solved yet",
                    "give tensioner.tension in place of pipe.anchor");
  }
  return std::nullopt;
}

/// Lines beside the pipe: straight wires from the pipe to what has its place.
std::optional<StaticFailure> lines_obstacle(const Description& description) {
  for (const FreeLineDescription& line : description.lines) {
    const bool first = is_on_pipe(description, line.first), second = is_on_pipe(description, line.second);
    if (!first && !second) {
      return StaticFailure{"a line beside the pipe that is not on it cannot be solved yet", line.name,
                           "give the pipe and that line in models of their own", true, "lines"};
    }
    const LineEndDescription& far = first ? line.second : line.first;
    if ((first && second) || far.kind == LineEndKind::line || far.kind == LineEndKind::free) {
      return StaticFailure{"a line on the pipe is held by nothing that has its place", line.name,
                           "its other end has to be fixed, on the bed, in the water or on the vessel", true, "lines"};
    }
    const bool stiff = std::ranges::any_of(line.segments, [](const LineSegmentDescription& segment) {
      return segment.section || segment.type.bending_stiffness > 0.0;
    });
    if (stiff || !line.points.empty()) {
      return StaticFailure{"a line on the pipe that is laid is a wire or a catenary", line.name,
                           "it may not have steel, bending stiffness or points of its own yet", true, "lines"};
    }
  }
  return std::nullopt;
}

}  // namespace

std::optional<std::string> pipe_obstacle(const Description& description, const std::string& what) {
  if (description.has_pipe) return std::nullopt;
  return "the model has no pipe for " + what + "; give the key pipe";
}

std::optional<StaticFailure> static_obstacle(const Description& description) {
  if (!description.has_pipe) {
    return obstacle("pipe", "the model has no pipe", "this analysis is that of a pipe");
  }
  if (std::optional<StaticFailure> failure = lines_obstacle(description)) return failure;
  const bool trimmed = description.vessel.coupled && description.vessel.coupled->ballast == Ballast::trim;
  if (!has_station(description) && !trimmed && (description.vessel.coupled || description.vessel.hydrostatics)) {
    return obstacle(
        description.vessel.coupled ? "vessel.motion.coupled" : "vessel.hydrostatics",
        "a pipe on a hull that sinks and trims under it cannot be solved yet without mooring lines",
        "give moorings, station_keeping, vessel.motion.coupled with ballast: trim, or leave out vessel.hydrostatics");
  }
  if (description.route.given()) return bent_route_obstacle(description);
  return std::nullopt;
}

}  // namespace overbend
