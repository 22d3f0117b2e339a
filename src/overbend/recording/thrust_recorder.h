/// Recording of dynamic positioning: thrust and time at its limits.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "base/finding.h"
#include "hull/hull.h"
#include "numerics/running_statistics.h"
#include "results/moored_dynamics.h"
#include "system/state.h"

namespace overbend {

/// Counts from t > 0.
class ThrustRecorder {
 public:
  /// `hull` must outlive this; if it is null or has no station keeping, nothing is recorded.
  explicit ThrustRecorder(const Hull* hull)
      : keeping_(hull != nullptr && hull->station_keeping ? &*hull->station_keeping : nullptr) {}

  bool positioned() const { return keeping_ != nullptr; }
  /// Sets the initial state of the run, which does not count.
  void start(const SystemState& state);
  /// Adds an accepted step of `step` [s]. Allocates nothing.
  void add(const SystemState& state, double step);
  /// Thrust at the last state: ahead, to port, bow to port relative to the low-frequency heading [N, N, N m].
  double given(std::size_t direction) const { return now_.given[static_cast<Eigen::Index>(direction)]; }
  std::vector<ThrustDynamics> results() const;
  /// Warns of each direction that was at its limit, with the duration.
  Findings findings() const;

  std::vector<double> save() const { return statistics_.save(); }
  void restore(const std::vector<double>& saved) { statistics_.restore(saved); }

 private:
  const StationKeeping* keeping_;
  StationThrust now_;
  /// For each direction the delivered thrust, the magnitude of the demand and 1 while the demand exceeds the limit,
  /// else 0.
  RunningStatistics statistics_{9};
};

}  // namespace overbend
