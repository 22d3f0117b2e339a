/// Poses and motions of bodies, and the loads of lines on them: plain data, SI units; frame W.
#pragma once

#include <string>

#include "base/vec.h"
#include "results/summary_statistics.h"

namespace overbend {

/// Static results of a body.
struct BodyResult {
  std::string name;
  bool floats = false;                               ///< True if lines and water determine the pose; otherwise the pose
                                                     ///< is prescribed.
  Vec3 place = Vec3::Zero();                         ///< Origin of the body: midship on its water line [m].
  double heading = 0.0;                              ///< Azimuth of its bow [rad].
  double surge = 0.0, sway = 0.0, heave = 0.0;       ///< Offset from the nominal pose: forward, to port, up [m].
  double roll = 0.0, pitch = 0.0, yaw = 0.0;         ///< Starboard down, bow down, bow to port [rad].
  Vec3 force = Vec3::Zero(), moment = Vec3::Zero();  ///< Resultant of all lines on the body, about its origin [N, N m].
};

/// Statistics of a body over time, from t = 0.
struct BodyDynamics {
  std::string name;
  SummaryStatistics surge, sway, heave, roll, pitch, yaw;  ///< Offset from the nominal pose, as in BodyResult [m, rad].
  SummaryStatistics pull;  ///< Magnitude of the horizontal force of all lines on the body [N].
};

}  // namespace overbend
