/// How a vessel that is moved ahead by joints goes along its way.
#pragma once

#include "model/description/mooring_description.h"

namespace overbend {

/// Place on the way, speed, acceleration.
struct WayPoint {
  double way = 0.0, speed = 0.0, acceleration = 0.0;  ///< [m, m/s, m/s2]
};

/// Moves of one length, one after the other. The way is C1 in time and starts and ends at rest.
struct MoveProfile {
  MoveShape shape = MoveShape::trapezoid;
  double distance = 0.0;  ///< Of one move; below zero astern [m].
  double speed = 0.15;    ///< Largest [m/s].
  double ramp = 10.0;     ///< To reach it and to stop [s].
  double start = 0.0;     ///< Of the first move [s].
  double wait = 0.0;      ///< Between the end of a move and the beginning of the next [s].
  int moves = 1;
  double period = 0.0;  ///< Of zero_vibration: undamped, of the surge that is not to be left behind [s].

  /// Of one move [s].
  double duration() const;
  /// Of the last move [s].
  double end() const { return start + moves * duration() + (moves - 1) * wait; }
  /// Of all moves [m].
  double whole_way() const { return moves * distance; }
  WayPoint at(double time) const;
};

/// As an operation describes it; `surge_period` for zero_vibration [s].
MoveProfile move_profile(const OperationDescription& operation, double surge_period);

}  // namespace overbend
