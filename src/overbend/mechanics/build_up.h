/// How waves and motion are brought in before t = 0.
#pragma once

namespace overbend {

/// A factor with its first two time derivatives.
struct BuildUp {
  double value = 1.0;         ///< [-]
  double rate = 0.0;          ///< [1/s]
  double acceleration = 0.0;  ///< [1/s2]
};

/// Half-cosine from 0 at t = -duration to 1 at t = 0; 1 from then on. `duration` 0 switches on at once.
BuildUp half_cosine(double t, double duration);

}  // namespace overbend
