#include "statics/moored/pull_ahead.h"

#include <cmath>
#include <utility>

#include "model/vessel/station.h"
#include "statics/moored/moored_results.h"

namespace overbend {
namespace {

constexpr int kMostTurns = 40;
constexpr double kStill = 1e-7;  ///< Of the ends of the hull, from one turn to the next [m].

}  // namespace

double way_between(const HullPlace& a, const HullPlace& b, double length) {
  return (a.p_W - b.p_W).norm() + 0.5 * length * (a.R_WV - b.R_WV).norm();
}

HullOnItsWay::HullOnItsWay(const Model& model, const MooredHull& start, PipeOnHull pipe)
    : model_(&model),
      pipe_(std::move(pipe)),
      hull_(start),
      from_(start.rest.offset),
      other_(start.hull.steady - pipe_.load),
      wished_(pulls_of(start.spread, start.rest.lines)) {
  if (start.hull.station) wanted_ = start.hull.station->wanted;
}

/// Pipe and hull take turns until the hull stays; on lines heave, roll and pitch alone move, by next to nothing.
std::optional<StaticFailure> HullOnItsWay::rest_with_pipe(const HullOffset& there) {
  const TensionBounds bounds = bounds_of(moorings_of(model_->description));
  HullOffset at = there;
  for (int turn = 0; turn < kMostTurns; ++turn) {
    if (pipe_.at) {
      std::variant<PipeThere, StaticFailure> pipe = pipe_.at(place_of(hull_.hull, at));
      if (const StaticFailure* failure = std::get_if<StaticFailure>(&pipe)) return *failure;
      const PipeThere& found = std::get<PipeThere>(pipe);
      hull_.hull.steady = other_ + found.load;
      step_.pipe = found.results;
    }
    hull_.rest = hull_.spread.lines.empty() ? find_rest(hull_.spread, hull_.hull, at)
                                            : plan_lengths(hull_.spread, hull_.hull, at, wished_, bounds);
    if (!hull_.rest.fault) hull_.rest.fault = broken_line(hull_);
    if (hull_.rest.fault) return StaticFailure{"no rest of the hull on its way", "", *hull_.rest.fault};
    const HullPlace before = place_of(hull_.hull, at), after = place_of(hull_.hull, hull_.rest.offset);
    if (!pipe_.at || way_between(before, after, model_->description.vessel.length) < kStill) return std::nullopt;
    at = hull_.rest.offset;
  }
  return StaticFailure{"pipe and moored hull do not come to rest together", "the vessel on its way",
                       "the pipe changes its pull with the vessel's place more than what keeps the vessel there"};
}

std::optional<StaticFailure> HullOnItsWay::go_to(double way) {
  HullOffset there = offset_ahead(from_, way);
  if (hull_.hull.station) {
    hull_.hull.station->wanted = wanted_;
    hull_.hull.station->wanted.head<2>() += (there - from_).head<2>();
  }
  there.segment<3>(2) = hull_.rest.offset.segment<3>(2);
  if (std::optional<StaticFailure> failure = rest_with_pipe(there)) return failure;
  step_.advance = way;
  step_.vessel = vessel_offset(hull_.rest.offset);
  step_.residual = hull_.rest.residual;
  step_.lengths.clear();
  step_.tensions.clear();
  for (std::size_t i = 0; i < hull_.spread.lines.size(); ++i) {
    const MooredLine& line = hull_.spread.lines[i];
    step_.lengths.push_back(line.line.first_segment());
    step_.tensions.push_back(line.parted ? 0.0 : hull_.rest.lines[i].tension());
  }
  return std::nullopt;
}

WinchPlan winch_plan(const OperationDescription& operation, const std::vector<MoveStep>& steps, double surge_period) {
  WinchPlan plan;
  plan.profile = move_profile(operation, surge_period);
  for (const MoveStep& step : steps) {
    plan.lengths.way.push_back(step.advance);
    plan.lengths.lengths.push_back(step.lengths);
  }
  return plan;
}

}  // namespace overbend
