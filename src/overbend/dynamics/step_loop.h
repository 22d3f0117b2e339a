/// What every loop in time has: how it begins, and how long its steps may be.
#pragma once

#include <algorithm>
#include <cmath>

#include "system/assembly.h"

namespace overbend {

inline constexpr double kLeastMotion = 1e-6;   ///< Of all lines: less is rest [m].
inline constexpr double kSmallestStep = 1e-7;  ///< [s]
inline constexpr double kMostGrowth = 1.5;     ///< Of the step, from one to the next.

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

/// The step after one of `h` that made an error of `error`, for an error of `tolerance`; `longest` at most [s].
inline double step_by_error(double h, double error, double tolerance, double longest) {
  const double growth = std::clamp(0.9 * std::cbrt(tolerance / std::max(error, 1e-12)), 0.3, kMostGrowth);
  return std::clamp(h * growth, kSmallestStep, longest);
}

}  // namespace overbend
