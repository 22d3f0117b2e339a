/// What a weld gathers on its way from the tensioner to the bed.
#pragma once

#include <span>
#include <vector>

namespace overbend {

/// How the pipe is laid: joint by joint.
struct LayPace {
  double joint = 0.0;      ///< Length of a move [m].
  double weld_time = 0.0;  ///< Of rest before each move [s].
  double move_time = 0.0;  ///< Of the move, at even speed [s].

  double speed() const { return joint / (weld_time + move_time); }  ///< Mean [m/s].
};

struct WeldPath {
  double mean = 0.0;   ///< Damage of the mean weld: the integral of the rate over the line by the mean lay speed.
  double worst = 0.0;  ///< Of the weld whose stops are the worst. All welds stop at the same places.
  std::vector<double> gathered;  ///< By the mean weld from the top to each station.
};

/// `s` ascending [m], the top last; damage rates [1/s] are straight between stations.
WeldPath weld_path(std::span<const double> s, std::span<const double> rate, const LayPace& pace);

}  // namespace overbend
