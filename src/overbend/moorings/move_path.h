/// The way of a hull that is pulled ahead by its winches: its places, the lengths that hold it there, and the lengths
/// in time that take it there.
#pragma once

#include "mechanics/move_profile.h"
#include "mechanics/winch.h"
#include "moorings/planner.h"

namespace overbend {

/// Places of one move besides its beginning: between them lengths are cubic.
inline constexpr int kPlacesOfMove = 24;

/// First segments of all lines by the way of the hull. Between its places cubic, C1.
struct LengthsByWay {
  std::vector<double> way;                   ///< Rising or falling [m].
  std::vector<std::vector<double>> lengths;  ///< Place by place, in the order of the lines [m].

  void add(double at, const MooringSpread& spread);
  /// Of one line: its length at a way within the table, and how it changes with the way.
  struct Length {
    double length = 0.0, slope = 0.0;  ///< [m, -]
  };
  Length at(std::size_t line, double at_way) const;
};

/// A pull-ahead: the way in time and the lengths that belong to it.
struct WinchPlan {
  MoveProfile profile;
  LengthsByWay lengths;
};

/// Where the hull is after `way` ahead along the lay route, its heading as drawn, whichever way it heads at `from` [m].
HullOffset offset_ahead(const HullOffset& from, double way);

/// Places of all moves: the first, then kPlacesOfMove for each [m].
std::vector<double> places_of(const MoveProfile& profile);

/// Lengths in time of every line: those of the place that the profile has the hull at, with rates that belong to them.
std::vector<LengthTable> winch_tables(const LengthsByWay& lengths, const MoveProfile& profile);

}  // namespace overbend
