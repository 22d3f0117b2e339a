/// What dynamic positioning gave over a run, and how long it was at its limits.
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
class ThrustWatch {
 public:
  /// `hull`: outlives this; null, or without station keeping: there is nothing to watch.
  explicit ThrustWatch(const Hull* hull)
      : keeping_(hull != nullptr && hull->station_keeping ? &*hull->station_keeping : nullptr) {}

  bool positioned() const { return keeping_ != nullptr; }
  /// The state that the run begins with, which does not count.
  void start(const SystemState& state);
  /// An accepted step of `step` [s]. Nothing is allocated.
  void add(const SystemState& state, double step);
  /// At the state added last: ahead, to port, bow to port of the slow heading [N, N, N m].
  double given(std::size_t direction) const { return now_.given[static_cast<Eigen::Index>(direction)]; }
  std::vector<ThrustDynamics> results() const;
  /// Of each direction that was at its limit, how long.
  Findings findings() const;

  std::vector<double> save() const { return statistics_.save(); }
  void restore(const std::vector<double>& saved) { statistics_.restore(saved); }

 private:
  const StationKeeping* keeping_;
  StationThrust now_;
  /// Of each direction what is given, the magnitude of what is asked for and, as 0 or 1, whether that is too much.
  RunningStatistics statistics_{9};
};

}  // namespace overbend
