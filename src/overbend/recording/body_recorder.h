/// Motions of the bodies other than the vessel, and line forces on them.
#pragma once

#include <array>
#include <vector>

#include "model/model.h"
#include "numerics/running_statistics.h"
#include "recording/history_columns.h"
#include "recording/vessel_recorder.h"
#include "results/body_results.h"
#include "system/assembly.h"

namespace overbend {

/// Counts from t = 0 on, each step weighted by its length.
class BodyRecorder {
 public:
  /// The bodies of the model start at number `first` among the bodies of the system. The model must outlive this.
  BodyRecorder(const Model& model, std::size_t first);

  /// Adds an accepted step. Allocates nothing.
  void add(const SystemState& state, const Assembly& assembly);
  std::vector<BodyDynamics> results() const;

  std::vector<double> save() const;
  void restore(const std::vector<double>& saved);

 private:
  const Model* model_;
  std::size_t first_;
  std::vector<VesselPose> nominal_;
  std::vector<RunningStatistics> statistics_;  ///< Surge to yaw from the nominal pose, and the horizontal line force.
};

/// Adds the histories of the bodies: motions and line forces.
void add_body_columns(const Model& model, std::size_t first, std::vector<RecordedColumn>& columns);

}  // namespace overbend
