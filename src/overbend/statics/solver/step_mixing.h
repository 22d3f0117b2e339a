/// Acceleration of an iteration with an inexact tangent.
#pragma once

#include <vector>

#include "base/dense_algebra.h"

namespace overbend {

/// Without plastic strain from supports upstream in the tangent, Newton's steps are those of a fixed-point iteration.
/// Changes between successive steps approximate the omitted part (Anderson 1965, Walker and Ni 2011).
class StepMixing {
 public:
  /// Mixes the previous steps into this step of a line and its far force.
  void mix(std::vector<double>& step, double& force);
  /// Records the part of the last mixed step that was taken.
  void record_taken(const std::vector<double>& step, double share, double force);
  /// Discards the stored steps.
  void forget();

 private:
  struct Change {
    Eigen::VectorXd asked, taken;
  };
  std::vector<Change> changes_;
  Eigen::VectorXd asked_, taken_;
};

}  // namespace overbend
