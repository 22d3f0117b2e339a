/// Where the vessel was over a run.
#pragma once

#include <array>
#include <vector>

#include "hull/pose_shift.h"
#include "model/model.h"
#include "numerics/running_statistics.h"
#include "results/moored_dynamics.h"

namespace overbend {

/// Counts from t > 0.
class VesselWatch {
 public:
  explicit VesselWatch(const VesselPose& drawn) : drawn_(drawn) {}

  /// Where it lies at the start of the run.
  void start(const VesselPose& pose);
  /// An accepted step of `step` [s] that led to `pose`. Nothing is allocated.
  void add(const VesselPose& pose, double time, double step);

  // At the pose added last.
  double shift(std::size_t freedom) const { return now_[freedom]; }  ///< From the drawn place [m, rad].
  double offset() const { return offset_; }                          ///< Horizontal, from the start [m].

  /// All but slow and wave parts.
  VesselDynamics results() const;
  std::vector<double> save() const { return statistics_.save(); }
  void restore(const std::vector<double>& saved) { statistics_.restore(saved); }

 private:
  void look(const VesselPose& pose);

  VesselPose drawn_;
  std::array<double, kVesselFreedoms> start_{}, now_{};
  double offset_ = 0.0;
  /// The freedoms, the offset, and the product of shifts along and across.
  RunningStatistics statistics_{kVesselFreedoms + 2};
};

}  // namespace overbend
