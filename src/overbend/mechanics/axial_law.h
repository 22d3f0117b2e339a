/// Axial force law of slack_law.h at one point (scalar form).
#pragma once

#include "mechanics/slack_law.h"

namespace overbend {

/// Force, its derivatives with the strain and with the extrapolated strain, and strain energy per length, all over EA.
struct AxialLaw {
  double force = 0.0, slope = 0.0, slope_ahead = 0.0, energy = 0.0;
};

/// Tension-only part of the law, over EA.
inline AxialLaw tension_only_law(double strain) {
  constexpr double d = kSlackStrain;
  if (strain >= d) return {strain, 0.0, 1.0, 0.5 * strain * strain + d * d / 6.0};
  if (strain <= -d) return {};
  const double x = strain + d;
  return {x * x / (4.0 * d), 0.0, x / (2.0 * d), x * x * x / (12.0 * d)};
}

/// Returns the law at `strain`, with `ahead` = strain + time * strain rate and `share` = fraction of EA effective in
/// compression. The energy is that of `strain`.
inline AxialLaw axial_law(double strain, double ahead, double share) {
  const AxialLaw pulls = tension_only_law(ahead);
  const double rest = 1.0 - share, x = 1.0 + strain, inverse = 1.0 / (x * x);
  return {0.25 * share * (x - inverse / x) + rest * pulls.force, 0.25 * share * (1.0 + 3.0 * inverse * inverse),
          rest * pulls.slope_ahead, 0.125 * share * (x * x + inverse - 2.0) + rest * tension_only_law(strain).energy};
}

}  // namespace overbend
