/// Axial law of slack_law.h at one point.
#pragma once

#include "mechanics/slack_law.h"

namespace overbend {

/// Force, its slope and energy per length, over EA.
struct AxialLaw {
  double force = 0.0, slope = 0.0, energy = 0.0;
};

inline AxialLaw axial_law(double strain, double share) {
  constexpr double d = kSlackStrain;
  AxialLaw pulls;
  if (strain >= d) {
    pulls = {strain, 1.0, 0.5 * strain * strain + d * d / 6.0};
  } else if (strain > -d) {
    const double x = strain + d;
    pulls = {x * x / (4.0 * d), x / (2.0 * d), x * x * x / (12.0 * d)};
  }
  const double rest = 1.0 - share;
  return {share * strain + rest * pulls.force, share + rest * pulls.slope,
          0.5 * share * strain * strain + rest * pulls.energy};
}

}  // namespace overbend
