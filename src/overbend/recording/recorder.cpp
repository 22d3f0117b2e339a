#include "recording/recorder.h"

#include <algorithm>

#include "base/ranges.h"
#include "dynamics/integrator/dynamic_checkpoint.h"
#include "dynamics/machines/mooring_tension.h"
#include "recording/control_columns.h"
#include "recording/move_recorder.h"
#include "recording/snapshots.h"

namespace overbend {
namespace {

/// True if the vessel floats freely, or statics have determined its equilibrium.
bool afloat(const Simulation& simulation, const StaticResults& statics) {
  return simulation.hull() != nullptr || !simulation.moorings().empty() || statics.moorings.has_value();
}

RecordedObjects make_recorded_objects(const Model& model, const Simulation& simulation, bool floating) {
  const bool pipe = find_laid_pipe(simulation.system()).has_value();
  const bool held = ranges::any_of(simulation.system().attachments, [&](const Attachment& attachment) {
    return attachment.body != kGround && attachment.body < static_cast<int>(simulation.first_body());
  });
  return {pipe ? &model.supports : nullptr,
          held || floating,
          floating,
          simulation.moorings(),
          pipe ? moving_sections(model) : std::vector<std::string>{},
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
  if (afloat(simulation, statics)) floating_.emplace(model.nominal_pose);
  columns_ = recorded_columns(make_recorded_objects(model, simulation, floating_.has_value()));
  if (simulation.move() != nullptr) add_move_columns(columns_, has_pipe);
  if (thrust_.positioned()) add_thrust_columns(columns_);
  add_body_columns(model, simulation.first_body(), columns_);
  add_control_columns(simulation.controllers(), columns_);
  row_.resize(columns_.size());
}

void Recorder::begun(const Instant& instant) {
  if (pipe_) pipe_->start(instant);
  moorings_.start(*instant.state, *instant.assembly);
  thrust_.start(*instant.state);
  if (floating_) floating_->start(instant.vessel().pose);
  const SnapshotSize size{pipe_ ? pipe_->stations() : 0, moorings_.points() + lines_.points()};
  snapshot_.resize(5 * static_cast<std::size_t>(size.stations) + kPoseNumbers +
                   4 * static_cast<std::size_t>(size.line_points));
  std::vector<HistoryColumn> columns;
  for (const RecordedColumn& recorded : columns_) columns.push_back(recorded.column);
  sink_->begin(columns, size);
}

void Recorder::stepped(const Instant& instant) {
  if (pipe_) pipe_->add(instant);
  moorings_.add(*instant.state, *instant.assembly, instant.step);
  thrust_.add(*instant.state, instant.step);
  if (floating_) floating_->add(instant.vessel().pose, instant.state->time, instant.step);
  lines_.add(*instant.state, *instant.assembly);
  bodies_.add(*instant.state, *instant.assembly);
}

void Recorder::impact(const EndedImpact& ended) {
  sink_->impact(pipe_->add_impact(ended));
}

void Recorder::row(const Instant& instant, std::int64_t number) {
  RowSource source{instant};
  if (pipe_) pipe_->fill_row(source);
  source.floating = floating_ ? &*floating_ : nullptr;
  source.thrust = &thrust_;
  std::transform(columns_.begin(), columns_.end(), row_.begin(),
                 [&](const RecordedColumn& recorded) { return recorded.value(source); });
  if (pipe_) pipe_->reset_interval();
  sink_->row(row_);
  if (number >= 0 && number % snapshot_stride_ == 0) sink_->snapshot(instant.state->time, snapshot(instant));
}

std::span<const double> Recorder::snapshot(const Instant& instant) {
  double* out = snapshot_.data();
  if (pipe_) out = pipe_->append_snapshot(out);
  out = put_pose(instant.vessel().pose, out);
  out = moorings_.append_snapshot(*instant.state, *instant.assembly, out);
  lines_.append_snapshot(*instant.state, *instant.assembly, out);
  return snapshot_;
}

double Recorder::top_tension() const {
  if (pipe_) return pipe_->top_tension();
  const Instant present = simulation_->present();
  double max_tension = 0.0;
  for (std::size_t i = 0; i < simulation_->moorings().size(); ++i) {
    max_tension = std::max(max_tension, mooring_tension(*present.assembly, *present.state, i, LineEnd::last));
  }
  for (const FollowedLine& line : simulation_->lines()) {
    max_tension = std::max(max_tension, end_tension(*present.assembly, *present.state, line, LineEnd::last));
  }
  return max_tension;
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
