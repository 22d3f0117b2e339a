/// Where the bodies besides the vessel go in a run, and what lines do to them.
#pragma once

#include <array>
#include <vector>

#include "model/model.h"
#include "numerics/running_statistics.h"
#include "recording/history_columns.h"
#include "recording/vessel_watch.h"
#include "results/body_results.h"
#include "system/assembly.h"

namespace overbend {

/// Counts from t = 0 on, every step by its length.
class BodyWatch {
 public:
  /// Those of the model stand from `first` on among the bodies of the system. The model must outlive it.
  BodyWatch(const Model& model, std::size_t first);

  /// An accepted step. Nothing is allocated.
  void add(const SystemState& state, const Assembly& assembly);
  std::vector<BodyDynamics> results() const;

  std::vector<double> save() const;
  void restore(const std::vector<double>& saved);

 private:
  const Model* model_;
  std::size_t first_;
  std::vector<VesselPose> drawn_;
  std::vector<RunningStatistics> statistics_;  ///< Surge to yaw from as drawn, and the horizontal pull.
};

/// Their histories: where they are, and how hard lines pull.
void add_body_columns(const Model& model, std::size_t first, std::vector<RecordedColumn>& columns);

}  // namespace overbend
