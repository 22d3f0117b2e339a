/// How much of a sea lies beside a range of frequencies.
#pragma once

#include "mechanics/sea.h"

namespace overbend {

/// Shares of the sea's variance, 0 to 1.
struct SeaBeside {
  double below = 0.0, above = 0.0;
};

/// Variance of the components below `lowest` and above `highest` [rad/s]. None in calm water.
inline SeaBeside sea_beside(const Sea& sea, double lowest, double highest) {
  double variance = 0.0;
  SeaBeside beside;
  for (const WaveComponent& c : sea.components) {
    const double share = c.amplitude * c.amplitude;
    variance += share;
    if (c.omega < lowest) beside.below += share;
    if (c.omega > highest) beside.above += share;
  }
  return variance > 0.0 ? SeaBeside{beside.below / variance, beside.above / variance} : SeaBeside{};
}

}  // namespace overbend
