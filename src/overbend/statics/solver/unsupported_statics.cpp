#include "statics/solver/unsupported_statics.h"

#include "base/ranges.h"
#include "model/lay_stage.h"
#include "model/pipe_attachments.h"
#include "model/vessel/mooring_queries.h"
#include "statics/solver/starting_point.h"

namespace overbend {
namespace {

StaticFailure unsupported(const char* key, const char* what, const char* why) {
  return {what, "", why, true, key};
}

std::optional<StaticFailure> unsupported_on_curved_route(const Description& description) {
  if (has_cable(description)) {
    return unsupported("route", "a line with a cable on a curved route is not supported", "leave out route");
  }
  if (find_target(description).kind == EquilibriumTarget::Kind::anchor_distance) {
    return unsupported("pipe.anchor", "an anchor distance on a curved route is not supported",
                       "give tensioner.tension in place of pipe.anchor");
  }
  return std::nullopt;
}

/// Lines attached to the pipe: straight wires from the pipe to fixed attachments.
std::optional<StaticFailure> unsupported_lines(const Description& description) {
  for (const FreeLineDescription& line : description.lines) {
    const bool first = is_on_pipe(description, line.first), second = is_on_pipe(description, line.second);
    if (!first && !second) {
      return StaticFailure{"a line that is not attached to the pipe is not supported in a lay", line.name,
                           "use separate models for the pipe and that line", true, "lines"};
    }
    const LineEndDescription& far = first ? line.second : line.first;
    if ((first && second) || far.kind == LineEndKind::line || far.kind == LineEndKind::free) {
      return StaticFailure{"a line on the pipe has no fixed attachment", line.name,
                           "its other end has to be fixed, on the bed, in the water or on the vessel", true, "lines"};
    }
    const bool stiff = ranges::any_of(line.segments, [](const LineSegmentDescription& segment) {
      return segment.section || segment.type.bending_stiffness > 0.0;
    });
    if (stiff || !line.points.empty()) {
      return StaticFailure{"a line on a pipe being laid must be a wire or a catenary", line.name,
                           "pipe sections, bending stiffness and points on it are not supported", true, "lines"};
    }
  }
  return std::nullopt;
}

}  // namespace

std::optional<std::string> missing_pipe_message(const Description& description, const std::string& what) {
  if (description.has_pipe) return std::nullopt;
  return "the model has no pipe for " + what + "; give the key pipe";
}

std::optional<StaticFailure> unsupported_in_statics(const Description& description) {
  if (!description.has_pipe) {
    return unsupported("pipe", "the model has no pipe", "this analysis requires a pipe");
  }
  if (std::optional<StaticFailure> failure = unsupported_lines(description)) return failure;
  const bool trimmed = description.vessel.coupled && description.vessel.coupled->ballast == Ballast::trim;
  if (!finds_vessel_position(description) && !trimmed &&
      (description.vessel.coupled || description.vessel.hydrostatics)) {
    return unsupported(
        description.vessel.coupled ? "vessel.motion.coupled" : "vessel.hydrostatics",
        "a pipe on a hull that sinks and trims is not supported without mooring lines",
        "give moorings, station_keeping, vessel.motion.coupled with ballast: trim, or leave out vessel.hydrostatics");
  }
  if (description.route.given()) return unsupported_on_curved_route(description);
  return std::nullopt;
}

}  // namespace overbend
