/// Initial accelerations of a time-domain simulation.
#pragma once

#include "system/assembly.h"

namespace overbend {

inline constexpr double kMinMotion = 1e-6;  ///< Minimum motion of all lines; less counts as rest [m].

/// Sets the ends of a state at rest in motion and computes the true and algorithmic accelerations. Returns false if the
/// mass matrix is singular. Uses the surroundings set last.
inline bool begin_motion(Assembly& assembly, SystemState& state) {
  assembly.impose_ends(state);
  if (!assembly.find_accelerations(state)) {
    return false;
  }
  for (LineState& line : state.lines) {
    line.algorithmic_acceleration = line.acc;
  }
  for (AttachmentState& attachment : state.attachments) {
    attachment.guide.algorithmic_acceleration = attachment.guide.acc;
  }
  for (HullState& body : state.bodies) {
    body.algorithmic_acceleration = body.acc;
  }
  return true;
}

}  // namespace overbend
