/// Law of a winch for the unstressed length of its line: prescribed length in time, and tension control where there is
/// no program. Tables are made from the keys of a winch or the plan of an operation.
#pragma once

#include <limits>
#include <vector>

#include "mechanics/tensioner.h"

namespace overbend {

/// Unstressed length of a line beyond its fairlead, and its rate, positive when paying out.
struct PaidOut {
  double length = 0.0;  ///< [m]
  double rate = 0.0;    ///< [m/s]
};

/// Length in time: cubic between its rows (Hermite), C1, at rest before the first and after the last. Only changes of
/// length matter: a winch starts with the length of its line.
struct LengthTable {
  std::vector<double> times;    ///< Rising [s].
  std::vector<double> lengths;  ///< [m]
  std::vector<double> rates;    ///< [m/s]; zero at both ends.

  bool empty() const { return times.empty(); }
  /// Returns length and rate at `time` [s].
  PaidOut at(double time) const;
};

/// Returns the table through these rows without overshoot, at rest at both ends (Fritsch and Carlson 1980).
LengthTable smooth_table(std::vector<double> times, std::vector<double> lengths);

/// Appends a change of length to a table: from `start` [s], not before the table's end, accelerating to `speed` [m/s]
/// within `ramp` [s] with a rate that begins and ends smoothly, and decelerating likewise. A change too small to reach
/// the speed is made within two ramps. Returns its end [s].
double add_move(LengthTable& table, double start, double change, double speed, double ramp);

/// A winch at a line end. Without program and tension it holds the length.
struct WinchLaw {
  LengthTable program;
  /// Tension at which hauling in stalls, and at which the brake renders: pay-out then keeps the tension there [N].
  double stall = std::numeric_limits<double>::infinity();
  double brake = std::numeric_limits<double>::infinity();
  /// Settings of a constant-tension winch: then there is no program. Its velocity, acceleration and limit also apply to
  /// speeds commanded by an external controller.
  TensionerLaw tension;
};

}  // namespace overbend
