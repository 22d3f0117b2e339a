/// Estimate of what a step has left out.
#pragma once

#include <vector>

#include "numerics/generalized_alpha.h"
#include "system/assembly.h"

namespace overbend {

/// Of a system whose lines keep their sizes.
class StepError {
 public:
  StepError(const System& system, const GeneralizedAlpha& scheme, double short_element);

  /// Estimate of the error that the step from `now` to `next` made in the place of any node or body (turned on its arm)
  /// [m]: the change of acceleration over the step times h^2 |1/6 - beta|, filtered by the system as `assembly` has it
  /// factored so that vibrations far faster than the step, which the scheme damps, do not count (after Shampine 1984).
  /// Beside elements longer than `short_element` errors of moorings and of laid pipe that was added behind the static
  /// line count less in proportion. `dq` is overwritten.
  double operator()(Assembly& assembly, const SystemState& now, const SystemState& next, Increments& dq) const;

 private:
  GeneralizedAlpha scheme_;
  std::vector<std::vector<double>> lumped_mass_;  ///< Line by line.
  std::vector<std::vector<double>> weights_;      ///< Line by line, of its nodes.
};

}  // namespace overbend
