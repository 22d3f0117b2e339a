/// Recording of the tensioner.
#pragma once

#include <array>
#include <vector>

#include "numerics/running_statistics.h"
#include "results/dynamic_results.h"
#include "system/assembly.h"

namespace overbend {

/// Counts from t = 0 on.
class TensionerRecorder {
 public:
  explicit TensionerRecorder(const TensionerLaw& law);

  /// Adds an accepted step of `step` [s].
  void add(const AttachmentState& tensioner, double paid_out, double time, double step);
  TensionerDynamics results() const;

  std::vector<double> save() const;
  void restore(const std::vector<double>& saved);

 private:
  const TensionerLaw* law_;
  RunningStatistics statistics_{2};  ///< Tension, travel.
  TensionerState last_ = TensionerState::hold;
  std::array<double, kTensionerStates> time_{};   ///< Time in each state [s].
  std::array<double, kTensionerStates> count_{};  ///< Number of times it entered each state.
  double out_of_range_ = 0.0;                     ///< Time out of the operational range [s].
};

}  // namespace overbend
