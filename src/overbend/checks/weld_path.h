/// Fatigue damage of a weld between tensioner and seabed.
#pragma once

#include <span>
#include <vector>

namespace overbend {

/// Schedule of joint-by-joint laying.
struct LayPace {
  double joint = 0.0;      ///< Length of a move, one joint [m].
  double weld_time = 0.0;  ///< Time at rest before each move [s].
  double move_time = 0.0;  ///< Duration of the move, at constant speed [s].

  double speed() const { return joint / (weld_time + move_time); }  ///< Mean [m/s].
};

struct WeldPath {
  /// Damage of the mean weld: the integral of the damage rate over the line divided by the mean lay speed.
  double mean = 0.0;
  double worst = 0.0;               ///< Damage of the weld with the worst stops. All welds stop at the same positions.
  std::vector<double> accumulated;  ///< Damage of the mean weld from the top to each station.
};

/// Integrates damage. `s` ascending [m], the top last; damage rates [1/s] are linear between stations.
WeldPath weld_path(std::span<const double> s, std::span<const double> rate, const LayPace& pace);

}  // namespace overbend
