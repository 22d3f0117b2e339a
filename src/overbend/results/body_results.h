/// Where bodies lie or go, and what lines do to them: plain data, SI units; frame W.
#pragma once

#include <string>

#include "base/vec.h"
#include "results/spread.h"

namespace overbend {

/// A body at rest.
struct BodyResult {
  std::string name;
  bool floats = false;                               ///< It lies where lines and water let it; else where it is put.
  Vec3 place = Vec3::Zero();                         ///< Of its origin, midship on its water line [m].
  double heading = 0.0;                              ///< Azimuth of its bow [rad].
  double surge = 0.0, sway = 0.0, heave = 0.0;       ///< From as drawn: forward, to port, up [m].
  double roll = 0.0, pitch = 0.0, yaw = 0.0;         ///< Starboard down, bow down, bow to port [rad].
  Vec3 force = Vec3::Zero(), moment = Vec3::Zero();  ///< Of all lines on it, about its origin [N, N m].
};

/// A body over time, from t = 0 on.
struct BodyDynamics {
  std::string name;
  Spread surge, sway, heave, roll, pitch, yaw;  ///< From as drawn, as in BodyResult [m, rad].
  Spread pull;                                  ///< Horizontal force of all lines on it, its size [N].
};

}  // namespace overbend
