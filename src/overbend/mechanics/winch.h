/// What a winch does with the unstressed length of its line: programs of length in time, and the law by which tension
/// decides where a program does not. Tables are made by the keys of a winch or by the plan of an operation.
#pragma once

#include <limits>
#include <vector>

#include "mechanics/tensioner.h"

namespace overbend {

/// Unstressed length of a line beyond its fairlead, and its rate: paying out counts positive.
struct PaidOut {
  double length = 0.0;  ///< [m]
  double rate = 0.0;    ///< [m/s]
};

/// A length in time: cubic between its rows (Hermite), C1, at rest before the first and after the last. Of the lengths
/// changes alone count: a winch begins with the line as it is.
struct LengthTable {
  std::vector<double> times;    ///< Rising [s].
  std::vector<double> lengths;  ///< [m]
  std::vector<double> rates;    ///< [m/s]; zero at both ends.

  bool empty() const { return times.empty(); }
  PaidOut at(double time) const;
};

/// The table through these rows without overshoot, at rest at both ends (Fritsch and Carlson 1980).
LengthTable smooth_table(std::vector<double> times, std::vector<double> lengths);

/// Adds a change of length to the end of a table: from `start` [s], not before the table's end, up to `speed` [m/s]
/// within `ramp` [s], with a rate that begins and ends without a kink, and down again. A change too small to reach the
/// speed is made within two ramps. Returns when it is done [s].
double add_move(LengthTable& table, double start, double change, double speed, double ramp);

/// A winch at the end of a line. Without program and tension it holds the length.
struct WinchLaw {
  LengthTable program;
  /// It stops hauling in at this tension [N], and its brake renders at the other: pays out as fast as holds it there.
  double stall = std::numeric_limits<double>::infinity();
  double brake = std::numeric_limits<double>::infinity();
  /// Controlled where the winch keeps a tension: then there is no program. Its velocity, acceleration and limit hold
  /// for speeds that somebody outside asks for as well.
  TensionerLaw tension;
};

}  // namespace overbend
