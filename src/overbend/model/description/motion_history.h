/// Recorded motion history of the vessel.
#pragma once

#include <array>
#include <string>
#include <vector>

namespace overbend {

/// Six freedoms at rising instants; signs as in RaoTable.
struct MotionHistory {
  std::vector<double> time;                     ///< [s]
  std::vector<std::array<double, 6>> freedoms;  ///< Surge, sway, heave [m], roll, pitch, yaw [rad].
  std::string source;                           ///< File it was read from.
  int passages =
      0;  ///< Times that an angle of the file passes from one end of the circle to the other; none does here.
};

}  // namespace overbend
