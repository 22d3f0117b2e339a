/// Recorded motion history of the vessel.
#pragma once

#include <array>
#include <string>
#include <vector>

namespace overbend {

/// Six degrees of freedom at increasing times; signs as in RaoTable.
struct MotionHistory {
  std::vector<double> time;                     ///< [s]
  std::vector<std::array<double, 6>> freedoms;  ///< Surge, sway, heave [m], roll, pitch, yaw [rad].
  std::string source;                           ///< Source file.
  int passages = 0;  ///< Number of angle wrap-arounds in the file; the stored angles are continuous.
};

}  // namespace overbend
