/// Part of a sea outside a range of frequencies.
#pragma once

#include "mechanics/sea.h"

namespace overbend {

/// Fractions of the sea's variance, 0 to 1.
struct SeaOutsideRange {
  double below = 0.0, above = 0.0;
};

/// Returns the variance fractions of the components below `lowest` and above `highest` [rad/s]; 0 in calm water.
inline SeaOutsideRange sea_outside_range(const Sea& sea, double lowest, double highest) {
  double variance = 0.0;
  SeaOutsideRange fractions;
  for (const WaveComponent& c : sea.components) {
    const double share = c.amplitude * c.amplitude;
    variance += share;
    if (c.omega < lowest) fractions.below += share;
    if (c.omega > highest) fractions.above += share;
  }
  return variance > 0.0 ? SeaOutsideRange{fractions.below / variance, fractions.above / variance} : SeaOutsideRange{};
}

}  // namespace overbend
