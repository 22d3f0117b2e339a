/// Path of a hull that is pulled ahead by its winches: positions, line lengths that hold it there, and line lengths
/// over time.
#pragma once

#include "mechanics/move_profile.h"
#include "mechanics/winch.h"
#include "moorings/planner.h"

namespace overbend {

/// Number of positions per move after its start; lengths are cubic between them.
inline constexpr int kPositionsPerMove = 24;

/// First-segment lengths of all lines as a function of the distance travelled. Cubic between positions, C1.
struct LengthsByDistance {
  std::vector<double> distances;             ///< Distance travelled; increasing or decreasing [m].
  std::vector<std::vector<double>> lengths;  ///< Per position, in the order of the lines [m].

  /// Appends the present first-segment lengths of a spread at a distance travelled [m].
  void add(double distance, const MooringSpread& spread);
  /// Length of one line at a distance within the table, and its derivative.
  struct Length {
    double length = 0.0, slope = 0.0;  ///< [m, -]
  };
  /// Interpolates the length of a line at a distance travelled [m].
  Length at(std::size_t line, double at_way) const;
};

/// Pull-ahead: distance over time and the corresponding lengths.
struct WinchPlan {
  MoveProfile profile;
  LengthsByDistance lengths;
};

/// Offset of the hull at `distance` ahead of `from` along the lay route, with the nominal heading at any heading of
/// `from` [m].
HullOffset offset_ahead(const HullOffset& from, double distance);

/// Distances of the positions of all moves: the first, then kPositionsPerMove per move [m].
std::vector<double> move_positions(const MoveProfile& profile);

/// Length of every line over time: lengths at the hull's distance in the profile, with consistent rates.
std::vector<LengthTable> winch_tables(const LengthsByDistance& lengths, const MoveProfile& profile);

}  // namespace overbend
