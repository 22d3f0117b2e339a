/// Ramp of waves and motion before t = 0.
#pragma once

namespace overbend {

/// Ramp factor with its first two time derivatives.
struct BuildUp {
  double value = 1.0;         ///< [-]
  double rate = 0.0;          ///< [1/s]
  double acceleration = 0.0;  ///< [1/s2]
};

/// Half-cosine from 0 at t = -duration to 1 at t = 0, then 1. `t` and `duration` in [s]; with `duration` 0 the factor
/// steps to 1 at t = 0.
BuildUp half_cosine(double t, double duration);

}  // namespace overbend
