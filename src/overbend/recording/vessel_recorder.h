/// Recording of the vessel's position.
#pragma once

#include <array>
#include <vector>

#include "hull/pose_shift.h"
#include "model/model.h"
#include "numerics/running_statistics.h"
#include "results/moored_dynamics.h"

namespace overbend {

/// Counts from t > 0.
class VesselRecorder {
 public:
  explicit VesselRecorder(const VesselPose& drawn) : nominal_(drawn) {}

  /// Sets the pose at the start of the run.
  void start(const VesselPose& pose);
  /// Adds an accepted step of `step` [s] that led to `pose`. Allocates nothing.
  void add(const VesselPose& pose, double time, double step);

  // At the last pose.
  double shift(std::size_t freedom) const { return now_[freedom]; }  ///< From the nominal pose [m, rad].
  double offset() const { return offset_; }                          ///< Horizontal distance from the start [m].

  /// Returns all results but slow and wave parts.
  VesselDynamics results() const;
  std::vector<double> save() const { return statistics_.save(); }
  void restore(const std::vector<double>& saved) { statistics_.restore(saved); }

 private:
  void evaluate(const VesselPose& pose);

  VesselPose nominal_;
  std::array<double, kVesselFreedoms> start_{}, now_{};
  double offset_ = 0.0;
  /// The freedoms, the offset, and the product of the displacements along and across.
  RunningStatistics statistics_{kVesselFreedoms + 2};
};

}  // namespace overbend
