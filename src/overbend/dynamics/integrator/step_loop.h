/// What every loop in time begins with.
#pragma once

#include "system/assembly.h"

namespace overbend {

inline constexpr double kLeastMotion = 1e-6;  ///< Of all lines: less is rest [m].

/// Puts the ends of a state at rest into motion and finds the accelerations, true and algorithmic; false where the mass
/// is singular. The surroundings are those set last.
inline bool begin_motion(Assembly& assembly, SystemState& state) {
  assembly.impose_ends(state);
  if (!assembly.find_accelerations(state)) {
    return false;
  }
  for (LineState& line : state.lines) {
    line.alg = line.acc;
  }
  for (AttachmentState& attachment : state.attachments) {
    attachment.guide.alg = attachment.guide.acc;
  }
  for (HullState& body : state.bodies) {
    body.alg = body.acc;
  }
  return true;
}

}  // namespace overbend
