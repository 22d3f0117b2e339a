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
  if (description.moorings && !description.moorings->lines.empty()) {
    return obstacle("a pipe and mooring lines cannot be solved together yet",
                    "give the moored vessel in a model of its own, with the pull of the pipe under vessel.loads");
  }
  if (description.vessel.coupled || description.vessel.hydrostatics) {
    return obstacle("a pipe on a hull that floats free cannot be solved yet",
                    "leave out vessel.hydrostatics, or give another vessel.motion than coupled");
  }
  return std::nullopt;
}

}  // namespace overbend
