/// Acceleration of an iteration whose tangent is not exact.
#pragma once

#include <vector>

#include "base/dense_algebra.h"

namespace overbend {

/// Where the tangent leaves out that steel remembers what bent it upstream, Newton's steps are those of a fixed-point
/// iteration. What the last of them changed in the next tells what is left out (Anderson 1965, Walker and Ni 2011).
class StepMixing {
 public:
  /// Mixes the last steps into this one of a line and its far force.
  void mix(std::vector<double>& step, double& force);
  /// What became of the step mixed last.
  void took(const std::vector<double>& step, double share, double force);
  void forget();

 private:
  struct Change {
    Eigen::VectorXd asked, taken;
  };
  std::vector<Change> changes_;
  Eigen::VectorXd asked_, taken_;
};

}  // namespace overbend
