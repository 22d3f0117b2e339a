#include "statics/static_obstacle.h"

namespace overbend {
namespace {

StaticFailure obstacle(const char* what, const char* why) {
  return {what, "", why, true};
}

}  // namespace

std::optional<StaticFailure> static_obstacle(const Description& description) {
  if (!description.has_pipe) {
    return obstacle("the model has no pipe", "this analysis is that of a pipe");
  }
  if (!description.lines.empty()) {
    return obstacle("lines beside a pipe cannot be solved yet", "give the pipe and the lines in models of their own");
  }
  const bool moored = description.moorings && !description.moorings->lines.empty();
  const bool trimmed = description.vessel.coupled && description.vessel.coupled->ballast == Ballast::trim;
  if (!moored && !trimmed && (description.vessel.coupled || description.vessel.hydrostatics)) {
    return obstacle("a pipe on a hull that sinks and trims under it cannot be solved yet without mooring lines",
                    "give moorings, vessel.motion.coupled with ballast: trim, or leave out vessel.hydrostatics");
  }
  return std::nullopt;
}

}  // namespace overbend
