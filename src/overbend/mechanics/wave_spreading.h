/// Directions of the components of a short-crested sea.
#pragma once

#include <vector>

#include "base/random.h"

namespace overbend {

/// Returns `count` angles [rad] from the mean direction, -pi to pi, distributed as cos^2s(angle/2)
/// [longuethiggins1963]. One angle is drawn from each of `count` slices of equal probability, and the slices are
/// shuffled.
std::vector<double> spread_directions(double s, int count, Random& random);

/// Returns `count` fractions, one from each of `count` equal slices of 0 to 1, in random order. Draws as many random
/// numbers as spread_directions.
std::vector<double> shuffled_fractions(int count, Random& random);

/// Distribution cos^2s(angle/2) over -pi to pi.
class CosineSpreading {
 public:
  explicit CosineSpreading(double s);
  /// Returns the angle [rad] below which the fraction `share`, 0 to 1, of the energy lies.
  double quantile(double share) const;

 private:
  double widest_ = 0.0, width_ = 0.0;  // [rad]
  std::vector<double> share_;          // cumulative
};

}  // namespace overbend
