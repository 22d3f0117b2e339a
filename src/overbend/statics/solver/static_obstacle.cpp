#include "statics/solver/static_obstacle.h"

#include "model/lay_stage.h"
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

}  // namespace

std::optional<std::string> pipe_obstacle(const Description& description, const std::string& what) {
  if (description.has_pipe) return std::nullopt;
  return "the model has no pipe for " + what + "; give the key pipe";
}

std::optional<StaticFailure> static_obstacle(const Description& description) {
  if (!description.has_pipe) {
    return obstacle("pipe", "the model has no pipe", "this analysis is that of a pipe");
  }
  if (!description.lines.empty()) {
    return obstacle("lines", "lines beside a pipe cannot be solved yet",
                    "give the pipe and the lines in models of their own");
  }
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
