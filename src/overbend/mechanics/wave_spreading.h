/// Directions of the components of a short-crested sea.
#pragma once

#include <vector>

#include "base/random.h"

namespace overbend {

/// Returns `count` angles [rad] from the mean direction, -pi to pi, distributed as cos^2s(angle/2)
/// [longuethiggins1963]. One angle is drawn from each of `count` slices of equal probability, and the slices are
/// shuffled.
std::vector<double> spread_directions(double s, int count, Random& random);

}  // namespace overbend
