/// Motion profile of a vessel that is moved ahead by joints.
#pragma once

#include "model/description/mooring_description.h"

namespace overbend {

/// Position, speed and acceleration along the path.
struct MoveState {
  double distance = 0.0, speed = 0.0, acceleration = 0.0;  ///< [m, m/s, m/s2]
};

/// Successive moves of equal length. The path is C1 in time and starts and ends at rest.
struct MoveProfile {
  MoveShape shape = MoveShape::trapezoid;
  double distance = 0.0;  ///< Length of one move, negative astern [m].
  double speed = 0.15;    ///< Maximum speed [m/s].
  double ramp = 10.0;     ///< Time to accelerate and to decelerate [s].
  double start = 0.0;     ///< Start of the first move [s].
  double wait = 0.0;      ///< Pause between moves [s].
  int moves = 1;
  double period = 0.0;  ///< For zero_vibration: undamped period of the surge motion to be suppressed [s].

  /// Returns the duration of one move [s].
  double duration() const;
  /// Returns the end of the last move [s].
  double end() const { return start + moves * duration() + (moves - 1) * wait; }
  /// Returns the length of all moves [m].
  double total_distance() const { return moves * distance; }
  /// Returns the state at `time` [s].
  MoveState at(double time) const;
};

/// Returns the profile of an operation; `surge_period` for zero_vibration [s].
MoveProfile move_profile(const OperationDescription& operation, double surge_period);

}  // namespace overbend
