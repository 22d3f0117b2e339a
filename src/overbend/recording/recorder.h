/// Everything that is recorded of a run: a recorder for every kind of object, rows of histories, snapshots.
#pragma once

#include <optional>
#include <vector>

#include "recording/body_watch.h"
#include "recording/history_columns.h"
#include "recording/line_recorder.h"
#include "recording/mooring_watch.h"
#include "recording/pipe_recorder.h"
#include "recording/thrust_watch.h"
#include "recording/vessel_watch.h"

namespace overbend {

/// Observes a simulation from its static state on and passes histories, snapshots and impacts to a sink.
class Recorder : public SimulationObserver {
 public:
  /// `statics` are the results of the state that the simulation starts from. All have to outlive the recorder.
  Recorder(const Model& model, const StaticResults& statics, const Simulation& simulation, DynamicSink& sink);

  void begun(const Instant& at) override;
  /// Statistics count from t > 0. Nothing is allocated.
  void stepped(const Instant& at) override;
  void impact(const EndedImpact& ended) override;
  /// Hands over the row and, now and then, a snapshot.
  void row(const Instant& at, std::int64_t number) override;
  void save(DynamicCheckpoint& checkpoint) const override;
  void restore(const DynamicCheckpoint& checkpoint) override;

  /// Of the pipe at its tensioner; without one the largest of the mooring lines at their fairleads, else of the lines
  /// at their second ends [N].
  double top_tension() const;
  /// Statistics into results; leaves what the recorder does not know.
  void fill(DynamicResults& results) const;
  /// Where there is a pipe.
  const std::optional<PipeRecorder>& pipe() const { return pipe_; }

 private:
  std::span<const double> snapshot(const Instant& at);

  const Model* model_;
  const StaticResults* statics_;
  const Simulation* simulation_;
  DynamicSink* sink_;
  std::optional<PipeRecorder> pipe_;
  MooringWatch moorings_;
  ThrustWatch thrust_;
  std::optional<VesselWatch> floating_;  ///< Of a vessel that floats free or lies on lines.
  LineRecorder lines_;
  BodyWatch bodies_;
  std::vector<RecordedColumn> columns_;
  std::int64_t snapshot_stride_;  ///< Rows from one to the next.
  std::vector<double> row_, snapshot_;
};

}  // namespace overbend
