#include "recording/recorder.h"

#include <algorithm>

#include "dynamics/integrator/dynamic_checkpoint.h"
#include "dynamics/machines/mooring_tension.h"
#include "recording/control_columns.h"
#include "recording/move_record.h"
#include "recording/snapshots.h"

namespace overbend {
namespace {

/// Whether the vessel floats free, or statics have found where it lies.
bool afloat(const Simulation& simulation, const StaticResults& statics) {
  return simulation.hull() != nullptr || !simulation.moorings().empty() || statics.moorings.has_value();
}

RecordedObjects objects_of(const Model& model, const Simulation& simulation, bool floating) {
  const bool pipe = find_laid_pipe(simulation.system()).has_value();
  const bool held = std::ranges::any_of(simulation.system().attachments, [&](const Attachment& attachment) {
    return attachment.body != kGround && attachment.body < static_cast<int>(simulation.first_body());
  });
  return {pipe ? &model.supports : nullptr,
          held || floating,
          floating,
          simulation.moorings(),
          pipe ? sections_in_time(model) : std::vector<std::string>{},
          astern_direction(model.mean_pose),
          simulation.lines()};
}

}  // namespace

Recorder::Recorder(const Model& model, const StaticResults& statics, const Simulation& simulation, DynamicSink& sink)
    : model_(&model),
      statics_(&statics),
      simulation_(&simulation),
      sink_(&sink),
      moorings_(model.description.moorings, simulation.moorings()),
      thrust_(simulation.hull()),
      lines_(model, simulation.system(), simulation.lines()),
      bodies_(model, simulation.first_body()),
      snapshot_stride_(snapshot_stride(simulation.options())) {
  const bool has_pipe = find_laid_pipe(simulation.system()).has_value();
  if (has_pipe) pipe_.emplace(model, statics, simulation);
  if (afloat(simulation, statics)) floating_.emplace(model.drawn_pose);
  columns_ = recorded_columns(objects_of(model, simulation, floating_.has_value()));
  if (simulation.move() != nullptr) add_move_columns(columns_, has_pipe);
  if (thrust_.positioned()) add_thrust_columns(columns_);
  add_body_columns(model, simulation.first_body(), columns_);
  add_control_columns(simulation.controllers(), columns_);
  row_.resize(columns_.size());
}

void Recorder::begun(const Instant& at) {
  if (pipe_) pipe_->start(at);
  moorings_.start(*at.state, *at.assembly);
  thrust_.start(*at.state);
  if (floating_) floating_->start(at.vessel().pose);
  const SnapshotSize size{pipe_ ? pipe_->stations() : 0, moorings_.points() + lines_.points()};
  snapshot_.resize(5 * static_cast<std::size_t>(size.stations) + kPoseNumbers +
                   4 * static_cast<std::size_t>(size.line_points));
  std::vector<HistoryColumn> columns;
  for (const RecordedColumn& recorded : columns_) columns.push_back(recorded.column);
  sink_->begin(columns, size);
}

void Recorder::stepped(const Instant& at) {
  if (pipe_) pipe_->add(at);
  moorings_.add(*at.state, *at.assembly, at.step);
  thrust_.add(*at.state, at.step);
  if (floating_) floating_->add(at.vessel().pose, at.state->time, at.step);
  lines_.add(*at.state, *at.assembly);
  bodies_.add(*at.state, *at.assembly);
}

void Recorder::impact(const EndedImpact& ended) {
  sink_->impact(pipe_->add_impact(ended));
}

void Recorder::row(const Instant& at, std::int64_t number) {
  RowSource source{at};
  if (pipe_) pipe_->show(source);
  source.floating = floating_ ? &*floating_ : nullptr;
  source.thrust = &thrust_;
  std::transform(columns_.begin(), columns_.end(), row_.begin(),
                 [&](const RecordedColumn& recorded) { return recorded.value(source); });
  if (pipe_) pipe_->forget_interval();
  sink_->row(row_);
  if (number >= 0 && number % snapshot_stride_ == 0) sink_->snapshot(at.state->time, snapshot(at));
}

std::span<const double> Recorder::snapshot(const Instant& at) {
  double* out = snapshot_.data();
  if (pipe_) out = pipe_->film(out);
  out = put_pose(at.vessel().pose, out);
  out = moorings_.film(*at.state, *at.assembly, out);
  lines_.film(*at.state, *at.assembly, out);
  return snapshot_;
}

double Recorder::top_tension() const {
  if (pipe_) return pipe_->top_tension();
  const Instant now = simulation_->now();
  double largest = 0.0;
  for (std::size_t i = 0; i < simulation_->moorings().size(); ++i) {
    largest = std::max(largest, mooring_tension(*now.assembly, *now.state, i, LineEnd::last));
  }
  for (const FollowedLine& line : simulation_->lines()) {
    largest = std::max(largest, end_tension(*now.assembly, *now.state, line, LineEnd::last));
  }
  return largest;
}

void Recorder::save(DynamicCheckpoint& checkpoint) const {
  if (pipe_) pipe_->save(checkpoint);
  checkpoint.arrays.push_back({"record/moorings", moorings_.save()});
  checkpoint.arrays.push_back({"record/thrust", thrust_.save()});
  if (floating_) checkpoint.arrays.push_back({"record/vessel", floating_->save()});
  checkpoint.arrays.push_back({"record/lines", lines_.save()});
  if (!model_->description.bodies.empty()) checkpoint.arrays.push_back({"record/bodies", bodies_.save()});
}

void Recorder::restore(const DynamicCheckpoint& checkpoint) {
  if (pipe_) pipe_->restore(checkpoint);
  moorings_.restore(checkpoint_array(checkpoint, "record/moorings"));
  thrust_.restore(checkpoint_array(checkpoint, "record/thrust"));
  if (floating_) floating_->restore(checkpoint_array(checkpoint, "record/vessel"));
  lines_.restore(checkpoint_array(checkpoint, "record/lines"));
  if (!model_->description.bodies.empty()) bodies_.restore(checkpoint_array(checkpoint, "record/bodies"));
}

void Recorder::fill(DynamicResults& results) const {
  if (pipe_) pipe_->fill(results);
  results.moorings = moorings_.results();
  results.thrust = thrust_.results();
  if (floating_) results.vessel = floating_->results();
  results.lines = lines_.results();
  results.bodies = bodies_.results();
  append(results.findings, moorings_.findings());
  append(results.findings, thrust_.findings());
  append(results.findings, line_findings(*model_, statics_->lines, results.lines));
  if (const MoveProfile* move = simulation_->move()) {
    assume_of_move(*model_, *move, results);
    warn_of_move(*model_, *move, results);
  }
}

}  // namespace overbend
