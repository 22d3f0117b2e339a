/// Results of a hull on its mooring lines in time, without a pipe: statistics, rows of histories, snapshots.
#pragma once

#include "dynamics/run/moored_simulation.h"
#include "recording/history_columns.h"
#include "recording/mooring_watch.h"
#include "recording/thrust_watch.h"

namespace overbend {

/// Observes the run of a simulation from its rest on and passes histories and snapshots to a sink. All have to outlive
/// it.
class MooredRecorder : public SystemObserver {
 public:
  MooredRecorder(const Model& model, const MooredSimulation& simulation, DynamicSink& sink);

  /// Statistics count from t > 0. Nothing is allocated.
  void stepped(const SystemRun& run) override;
  void row(const SystemRun& run) override;
  void save(DynamicCheckpoint& checkpoint) const override;
  void restore(const DynamicCheckpoint& checkpoint) override;

  /// The largest at a fairlead, at the last instant [N].
  double largest_tension() const;
  /// Statistics into results; leaves what the recorder does not know.
  void fill(DynamicResults& results) const;

 private:
  const Model* model_;
  const MooredSimulation* simulation_;
  DynamicSink* sink_;
  MooringWatch moorings_;
  VesselWatch vessel_;
  ThrustWatch thrust_;
  std::vector<RecordedColumn> columns_;
  std::int64_t snapshot_stride_;  ///< Rows from one to the next.
  std::vector<double> row_, snapshot_;
};

}  // namespace overbend
