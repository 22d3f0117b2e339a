/// Axial law of slack_law.h at one point.
#pragma once

#include "mechanics/slack_law.h"

namespace overbend {

/// Force, its slope by strain and by strain ahead, and energy per length, over EA.
struct AxialLaw {
  double force = 0.0, slope = 0.0, slope_ahead = 0.0, energy = 0.0;
};

/// The part that pulls.
inline AxialLaw pulling_law(double strain) {
  constexpr double d = kSlackStrain;
  if (strain >= d) return {strain, 0.0, 1.0, 0.5 * strain * strain + d * d / 6.0};
  if (strain <= -d) return {};
  const double x = strain + d;
  return {x * x / (4.0 * d), 0.0, x / (2.0 * d), x * x * x / (12.0 * d)};
}

/// `ahead`: strain + time * rate of strain. The energy is that of `strain`.
inline AxialLaw axial_law(double strain, double ahead, double share) {
  const AxialLaw pulls = pulling_law(ahead);
  const double rest = 1.0 - share, x = 1.0 + strain, inverse = 1.0 / (x * x);
  return {0.25 * share * (x - inverse / x) + rest * pulls.force, 0.25 * share * (1.0 + 3.0 * inverse * inverse),
          rest * pulls.slope_ahead, 0.125 * share * (x * x + inverse - 2.0) + rest * pulling_law(strain).energy};
}

}  // namespace overbend
