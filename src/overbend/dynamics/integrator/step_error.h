/// Local error estimate of a time step.
#pragma once

#include <vector>

#include "numerics/generalized_alpha.h"
#include "system/assembly.h"

namespace overbend {

/// Error estimator of a system whose lines keep their sizes.
class StepError {
 public:
  StepError(const System& system, const GeneralizedAlpha& scheme, double short_element);

  /// Returns the estimated error of the step from `start` to `next` in the position of any node or body (rotations
  /// times its arm) [m]: the change of acceleration over the step times h^2 |1/6 - beta|, filtered by the system as
  /// factored in `assembly` so that vibrations far faster than the step, which the scheme damps, do not count (after
  /// Shampine 1984). At elements longer than `short_element` the errors of moorings and of laid pipe added behind the
  /// static line are reduced in proportion. `dq` is overwritten.
  double operator()(Assembly& assembly, const SystemState& start, const SystemState& next, Increments& dq) const;

 private:
  GeneralizedAlpha scheme_;
  std::vector<std::vector<double>> lumped_mass_;  ///< Per line.
  std::vector<std::vector<double>> weights_;      ///< Per line and node.
};

}  // namespace overbend
