#include "statics/moored/pull_ahead.h"

#include <cmath>
#include <utility>

#include "model/vessel/mooring_queries.h"
#include "statics/moored/moored_results.h"

namespace overbend {
namespace {

constexpr int kMaxIterations = 40;
constexpr double kConvergedMove = 1e-7;  ///< Displacement of the hull's ends between iterations at convergence [m].

}  // namespace

double end_displacement(const HullPlace& a, const HullPlace& b, double length) {
  return (a.p_W - b.p_W).norm() + 0.5 * length * (a.R_WV - b.R_WV).norm();
}

PullAheadPath::PullAheadPath(const Model& model, const MooredHull& start, PipeOnHull pipe)
    : model_(&model),
      pipe_(std::move(pipe)),
      hull_(start),
      from_(start.rest.offset),
      load_without_pipe_(start.hull.steady - pipe_.load),
      wanted_pulls_(horizontal_pulls(start.spread, start.rest.lines)) {
  if (start.hull.station) wanted_ = start.hull.station->wanted;
}

/// Iterates between pipe and hull until the hull's position converges; on lines only heave, roll and pitch change,
/// slightly.
std::optional<StaticFailure> PullAheadPath::solve_with_pipe(const HullOffset& start) {
  const TensionBounds bounds = make_tension_bounds(find_moorings(model_->description));
  HullOffset offset = start;
  for (int turn = 0; turn < kMaxIterations; ++turn) {
    if (pipe_.solve_at) {
      std::variant<PipeAtPosition, StaticFailure> pipe = pipe_.solve_at(make_hull_place(hull_.hull, offset));
      if (const StaticFailure* failure = std::get_if<StaticFailure>(&pipe)) return *failure;
      const PipeAtPosition& found = std::get<PipeAtPosition>(pipe);
      hull_.hull.steady = load_without_pipe_ + found.load;
      step_.pipe = found.results;
    }
    hull_.rest = hull_.spread.lines.empty() ? find_hull_equilibrium(hull_.spread, hull_.hull, offset)
                                            : plan_lengths(hull_.spread, hull_.hull, offset, wanted_pulls_, bounds);
    if (!hull_.rest.error) hull_.rest.error = broken_line(hull_);
    if (hull_.rest.error) {
      return StaticFailure{"no equilibrium of the hull during the pull-ahead", "", *hull_.rest.error};
    }
    const HullPlace before = make_hull_place(hull_.hull, offset),
                    after = make_hull_place(hull_.hull, hull_.rest.offset);
    if (!pipe_.solve_at || end_displacement(before, after, model_->description.vessel.length) < kConvergedMove) {
      return std::nullopt;
    }
    offset = hull_.rest.offset;
  }
  return StaticFailure{"no common equilibrium of pipe and moored hull was found", "the vessel during the pull-ahead",
                       "the pipe load changes more with the vessel's position than the restoring force"};
}

std::optional<StaticFailure> PullAheadPath::advance_to(double distance) {
  HullOffset target = offset_ahead(from_, distance);
  if (hull_.hull.station) {
    hull_.hull.station->wanted = wanted_;
    hull_.hull.station->wanted.head<2>() += (target - from_).head<2>();
  }
  target.segment<3>(2) = hull_.rest.offset.segment<3>(2);
  if (std::optional<StaticFailure> failure = solve_with_pipe(target)) return failure;
  step_.advance = distance;
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
    plan.lengths.distances.push_back(step.advance);
    plan.lengths.lengths.push_back(step.lengths);
  }
  return plan;
}

}  // namespace overbend
