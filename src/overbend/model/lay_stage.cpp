#include "model/lay_stage.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/constants.h"
#include "base/ranges.h"
#include "model/description/description.h"

namespace overbend {
namespace {

/// Returns the member of a stage that measures the progress of the operation.
std::optional<double> LayStageDescription::*find_progress_member(OperationType type) {
  switch (type) {
    case OperationType::start_up:
    case OperationType::shore_pull:
    case OperationType::hold_back:
      return &LayStageDescription::pipe_out;
    case OperationType::move:
      return &LayStageDescription::ahead;
    case OperationType::passage:
      return &LayStageDescription::passed;
    case OperationType::ballast:
      return &LayStageDescription::tank_ballast;
    default:
      return &LayStageDescription::cable_out;
  }
}

/// Returns a linear interpolation of evenly spaced values at the fraction `share` of the range.
double along_series(const std::vector<double>& values, double share) {
  const double position = share * static_cast<double>(values.size() - 1);
  const std::size_t i = std::min(static_cast<std::size_t>(position), values.size() - 1);
  const std::size_t next = std::min(i + 1, values.size() - 1);
  return values[i] + (position - static_cast<double>(i)) * (values[next] - values[i]);
}

std::vector<LayStageDescription> generated(const StageProgram& program, OperationType type) {
  std::vector<LayStageDescription> stages;
  for (int i = 0; i <= program.steps; ++i) {
    const double share = static_cast<double>(i) / program.steps;
    LayStageDescription& stage = stages.emplace_back();
    stage.*find_progress_member(type) = program.from + share * (program.to - program.from);
    if (program.tension == StageTension::hold && !program.values.empty()) {
      stage.tension = along_series(program.values, share);
    }
    if (program.tension == StageTension::bottom) stage.bottom_tension = program.bottom_tension;
  }
  return stages;
}

/// A winch does not use the range of the tensioner: in dynamics its brake holds.
void set_brake_mode(TensionerDescription& tensioner) {
  tensioner.mode = TensionerMode::locked;
  tensioner.range_low.reset();
  tensioner.range_high.reset();
}

/// Returns true if the tensioner's range does not contain its set tension.
bool outside_range(const TensionerDescription& tensioner) {
  const double tension = tensioner.tension.value_or(0.0);
  return tensioner.range_low && tensioner.range_high &&
         (tension < *tensioner.range_low || tension > *tensioner.range_high);
}

void fill_tank(SupportsDescription& supports, const std::string& name, const LayStageDescription& stage) {
  for (StingerSectionDescription& section : supports.sections) {
    for (StingerTankDescription& tank : section.tanks) {
      if (tank.name != name) continue;
      tank.weight = stage.tank_weight.value_or(tank.weight);
      tank.ballast = stage.tank_ballast.value_or(tank.ballast);
    }
  }
}

/// Returns the lift with the stages up to the named one, since each stage continues from those before.
Description keep_stages_up_to(Description d, const std::string& name) {
  std::vector<LayStageDescription>& stages = d.operation.lay.stages;
  const std::vector<LayStageDescription> named = lay_stages(d);
  const auto last = ranges::find(named, name, &LayStageDescription::name);
  if (last != named.end()) stages.resize(static_cast<std::size_t>(last - named.begin()) + 1);
  return d;
}

}  // namespace

std::vector<LayStageDescription> lay_stages(const Description& description) {
  const LayOperationDescription& lay = description.operation.lay;
  std::vector<LayStageDescription> stages =
      lay.program ? generated(*lay.program, description.operation.type) : lay.stages;
  if (description.operation.type == OperationType::recovery) std::reverse(stages.begin(), stages.end());
  const bool sought = lay.program && lay.program->tension == StageTension::seek;
  const bool follows = lay.anchor && lay.anchor->distance;  // true if the tension follows from the anchor position
  for (std::size_t i = 0; i < stages.size(); ++i) {
    LayStageDescription& stage = stages[i];
    if (stage.name.empty()) stage.name = fmt::format("stage {}", i + 1);
    if (!stage.tension && !stage.bottom_tension && !sought && !follows) stage.tension = description.tensioner.tension;
  }
  return stages;
}

Description make_stage_description(const Description& description, const LayStageDescription& stage) {
  Description d = description;
  const LayOperationDescription& lay = d.operation.lay;
  d.stage = stage;
  if (d.operation.type == OperationType::lift) return keep_stages_up_to(std::move(d), stage.name);
  if (stage.tension) d.tensioner.tension = stage.tension;
  if (cable_at_top(d)) {
    d.tensioner.guide = Guide::pinned;
    set_brake_mode(d.tensioner);
    if (lay.winch) {
      d.tensioner.x = lay.winch->x;
      d.tensioner.z = lay.winch->z;
    }
  }
  if (stage.passed) {
    for (StructureDescription& structure : d.pipe.structures) {
      if (structure.name == lay.structure) structure.at = stage.passed;
    }
  }
  if (stage.tank_weight || stage.tank_ballast) fill_tank(d.supports, lay.tank, stage);
  if (outside_range(d.tensioner)) set_brake_mode(d.tensioner);
  if (is_dragged(d)) {
    d.pipe.length.reset();
    d.statics.roller_friction = dragging_direction(d) > 0.0 ? RollerFriction::lay : RollerFriction::haul;
  }
  if (cable_at_far_end(d) && !is_dragged(d)) {
    d.pipe.length = *stage.pipe_out + lay.head->length + *lay.cable->length;
    d.pipe.anchor = lay.anchor->distance;
    if (lay.anchor->distance && !stage.tension) d.tensioner.tension.reset();
  }
  return d;
}

bool cable_at_top(const Description& description) {
  return description.stage && description.stage->cable_out && description.operation.lay.cable;
}

double pipe_start_distance(const Description& description) {
  if (!cable_at_top(description)) return 0.0;
  return *description.stage->cable_out + description.operation.lay.head->length;
}

double pipe_end_distance(const Description& description) {
  return cable_at_far_end(description) ? *description.stage->pipe_out : kInfinity;
}

double pipe_shift(const Description& description) {
  if (!cable_at_far_end(description)) {
    const double ahead = description.stage ? description.stage->ahead.value_or(0.0) : 0.0;
    return pipe_start_distance(description) + ahead;
  }
  const double out = *description.stage->pipe_out;
  double last = out;
  for (const LayStageDescription& stage : lay_stages(description)) last = std::max(last, stage.pipe_out.value_or(out));
  return out - last;
}

bool has_cable(const Description& description) {
  return cable_at_top(description) || cable_at_far_end(description);
}

bool cable_at_far_end(const Description& description) {
  return description.stage && description.stage->pipe_out && description.operation.lay.cable;
}

bool is_dragged(const Description& description) {
  return cable_at_far_end(description) && drags_along_bed(description.operation.type);
}

double dragging_direction(const Description& description) {
  if (!is_dragged(description)) return 0.0;
  return description.operation.type == OperationType::shore_pull ? 1.0 : -1.0;
}

}  // namespace overbend
