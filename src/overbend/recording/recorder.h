/// Recording of a run: a recorder for every kind of object, rows of histories, snapshots.
#pragma once

#include <optional>
#include <vector>

#include "recording/body_recorder.h"
#include "recording/history_columns.h"
#include "recording/line_recorder.h"
#include "recording/mooring_recorder.h"
#include "recording/pipe_recorder.h"
#include "recording/thrust_recorder.h"
#include "recording/vessel_recorder.h"

namespace overbend {

/// Observes a simulation from its static state on and passes histories, snapshots and impacts to a sink.
class Recorder : public SimulationObserver {
 public:
  /// `statics` are the results of the initial state of the simulation. All arguments must outlive the recorder.
  Recorder(const Model& model, const StaticResults& statics, const Simulation& simulation, DynamicSink& sink);

  void begun(const Instant& instant) override;
  /// Adds an accepted step. Statistics count from t > 0. Allocates nothing.
  void stepped(const Instant& instant) override;
  void impact(const EndedImpact& ended) override;
  /// Passes the row and, at intervals, a snapshot to the sink.
  void row(const Instant& instant, std::int64_t number) override;
  void save(DynamicCheckpoint& checkpoint) const override;
  void restore(const DynamicCheckpoint& checkpoint) override;

  /// Tension of the pipe at its tensioner; without a pipe the maximum of the mooring lines at their fairleads, else of
  /// the lines at their second ends [N].
  double top_tension() const;
  /// Fills the recorded results; leaves the others unchanged.
  void fill(DynamicResults& results) const;
  /// Recorder of the pipe, if there is one.
  const std::optional<PipeRecorder>& pipe() const { return pipe_; }

 private:
  std::span<const double> snapshot(const Instant& instant);

  const Model* model_;
  const StaticResults* statics_;
  const Simulation* simulation_;
  DynamicSink* sink_;
  std::optional<PipeRecorder> pipe_;
  MooringRecorder moorings_;
  ThrustRecorder thrust_;
  std::optional<VesselRecorder> floating_;  ///< Set for a vessel that floats freely or lies on mooring lines.
  LineRecorder lines_;
  BodyRecorder bodies_;
  std::vector<RecordedColumn> columns_;
  std::int64_t snapshot_stride_;  ///< Number of rows between snapshots.
  std::vector<double> row_, snapshot_;
};

}  // namespace overbend
