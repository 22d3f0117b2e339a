#include "recording/moored_recorder.h"

#include <algorithm>

#include "dynamics/integrator/dynamic_checkpoint.h"
#include "dynamics/machines/mooring_tension.h"
#include "recording/move_record.h"
#include "recording/snapshots.h"

namespace overbend {
namespace {

const VesselPose& pose_of(const SystemRun& run) {
  return run.assembly().surroundings().bodies.front().pose;
}

}  // namespace

MooredRecorder::MooredRecorder(const Model& model, const MooredSimulation& simulation, DynamicSink& sink)
    : model_(&model),
      simulation_(&simulation),
      sink_(&sink),
      moorings_(model.description.moorings, simulation.moorings()),
      vessel_(model.drawn_pose),
      thrust_(simulation.hull()),
      columns_(moored_columns(simulation.moorings())),
      snapshot_stride_(snapshot_stride(simulation.run().options())) {
  if (simulation.move() != nullptr) add_move_columns(columns_, false);
  if (thrust_.positioned()) add_thrust_columns(columns_);
  const SystemRun& run = simulation.run();
  moorings_.start(run.state(), run.assembly());
  vessel_.start(pose_of(run));
  thrust_.start(run.state());
  row_.resize(columns_.size());
  snapshot_.resize(kPoseNumbers + 4 * static_cast<std::size_t>(moorings_.points()));
  std::vector<HistoryColumn> columns;
  for (const RecordedColumn& recorded : columns_) columns.push_back(recorded.column);
  sink_->begin(columns, {0, moorings_.points()});
}

void MooredRecorder::stepped(const SystemRun& run) {
  const double step = run.state().last_step;
  moorings_.add(run.state(), run.assembly(), step);
  vessel_.add(pose_of(run), run.time(), step);
  thrust_.add(run.state(), step);
}

void MooredRecorder::row(const SystemRun& run) {
  Instant now;
  now.state = &run.state();
  now.assembly = &run.assembly();
  now.step = run.state().last_step;
  now.elevation = simulation_->elevation();
  now.drift = run.energy().drift();
  if (const MoveProfile* move = simulation_->move()) now.move.way = move->at(run.time());
  const RowSource source{now, {}, {}, {}, {}, {}, &vessel_, &thrust_};
  std::transform(columns_.begin(), columns_.end(), row_.begin(),
                 [&](const RecordedColumn& recorded) { return recorded.value(source); });
  sink_->row(row_);
  const std::int64_t number = run.row_number();
  if (number < 0 || number % snapshot_stride_ != 0) return;
  moorings_.film(run.state(), run.assembly(), put_pose(pose_of(run), snapshot_.data()));
  sink_->snapshot(run.time(), snapshot_);
}

double MooredRecorder::largest_tension() const {
  const SystemRun& run = simulation_->run();
  double largest = 0.0;
  for (std::size_t i = 0; i < simulation_->moorings().size(); ++i) {
    largest = std::max(largest, mooring_tension(run.assembly(), run.state(), i, LineEnd::last));
  }
  return largest;
}

void MooredRecorder::save(DynamicCheckpoint& checkpoint) const {
  checkpoint.arrays.push_back({"record/moorings", moorings_.save()});
  checkpoint.arrays.push_back({"record/vessel", vessel_.save()});
  checkpoint.arrays.push_back({"record/thrust", thrust_.save()});
}

void MooredRecorder::restore(const DynamicCheckpoint& checkpoint) {
  moorings_.restore(checkpoint_array(checkpoint, "record/moorings"));
  vessel_.restore(checkpoint_array(checkpoint, "record/vessel"));
  thrust_.restore(checkpoint_array(checkpoint, "record/thrust"));
}

void MooredRecorder::fill(DynamicResults& results) const {
  results.moorings = moorings_.results();
  results.vessel = vessel_.results();
  results.thrust = thrust_.results();
  append(results.findings, moorings_.findings());
  append(results.findings, thrust_.findings());
  if (const MoveProfile* move = simulation_->move()) {
    assume_of_move(*model_, *move, results);
    warn_of_move(*model_, *move, results);
  }
}

}  // namespace overbend
