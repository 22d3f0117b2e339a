#include "statics/solver/anchored_lay.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <iterator>

#include "base/ranges.h"
#include "base/shown_unit.h"
#include "model/lay_stage.h"
#include "statics/solver/starting_point.h"

namespace overbend {
namespace {

constexpr int kMaxEvaluations = 100;
constexpr int kMaxFailures = 4;              ///< Number of tensions without an equilibrium after which the search ends.
constexpr double kPositionTolerance = 1e-9;  ///< Tolerance of the far end's position relative to the line's length.
constexpr double kClosed = 1e-7;             ///< Relative width of a bracket at which the search ends.
constexpr double kClosedUnsolved = 1e-4;     ///< Same if one end of the bracket has no solution.
constexpr double kDirectChange =
    0.1;                         ///< Relative change of tension below which the anchor's place is solved for at once.
constexpr double kGrowth = 1.4;  ///< Factor between tensions without an estimate.
constexpr double kMaxFactor = 3.0;  ///< Maximum factor between successive tensions outside a bracket.

/// Lay of given tension in the search.
struct Trial {
  double tension = 0.0;        ///< [N]
  std::optional<double> miss;  ///< Distance of the far end beyond the anchor [m]; nullopt if there is no solution.
};

class AnchorSearch {
 public:
  AnchorSearch(const Model& model, const LoadHistory& past)
      : model_(model),
        past_(past),
        pulled_(model),
        plane_(lay_plane(model, model.mean_pose)),
        target_(find_target(model.description)),
        tolerance_(kPositionTolerance * *model.description.pipe.length) {}

  StaticOutcome run() {
    const auto begin = std::chrono::steady_clock::now();
    if (!search()) return {std::nullopt, explain()};
    report_.wall_time = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    report_.method = "newton, tension sought for the anchor";
    solution_->report = report_;
    return {std::move(solution_), std::nullopt};
  }

 private:
  bool search() {
    double tension = tension_for_anchor(model_, plane_);
    for (int i = 0; i < kMaxEvaluations && failures_ < kMaxFailures && !closed(); ++i) {
      if (evaluate(tension)) return true;
      if (failure_ && failure_->input) return false;
      const double next = next_tension(tension);
      const bool near = !failure_ && std::abs(next / tension - 1.0) < kDirectChange;
      if (near && take(continue_statics(model_, *solution_, past_))) return true;
      tension = next;
    }
    return false;
  }

  /// Stores a solution and adds up its effort; returns false if there is none.
  bool take(StaticOutcome outcome) {
    if (!outcome.solution) return false;
    solution_ = std::move(outcome.solution);
    report_.iterations += solution_->report.iterations;
    report_.relaxation_steps += solution_->report.relaxation_steps;
    report_.force_residual = solution_->report.force_residual;
    ranges::copy(solution_->report.history, std::back_inserter(report_.history));
    return true;
  }

  /// Solves the lay of a given tension; returns true if its far end is at the anchor.
  bool evaluate(double tension) {
    pulled_.description.tensioner.tension = tension;
    StaticOutcome outcome = solve_statics(pulled_, solution_ ? &*solution_ : nullptr, past_);
    failure_ = std::move(outcome.failure);
    Trial trial{tension, std::nullopt};
    if (take(std::move(outcome))) {
      trial.miss = far_distance() - target_.value;
      solved_ = {solved_[1], trial};
      failed_at_.reset();
      (*trial.miss < 0.0 ? low_ : high_) = trial;
      return std::abs(*trial.miss) <= tolerance_;
    }
    if (failure_->kind == FailureKind::tension_too_low) {
      low_ = trial;
    } else if (failure_->kind == FailureKind::no_touchdown) {
      high_ = trial;
    } else {
      ++failures_;
      failed_at_ = tension;
    }
    return false;
  }

  double far_distance() const {
    return (Eigen::Map<const Vec3>(solution_->state.q.data()) - plane_.tensioner_W).dot(plane_.astern_W);
  }

  bool closed() const {
    if (!low_ || !high_) return false;
    const double width = high_->tension / low_->tension - 1.0;
    return width < (low_->miss && high_->miss ? kClosed : kClosedUnsolved);
  }

  double next_tension(double last) {
    if (failed_at_) return tension_near_failure(*failed_at_);
    const std::optional<double> secant = secant_tension();
    const bool inside = secant && (!low_ || *secant > low_->tension) && (!high_ || *secant < high_->tension);
    if (low_ && high_) return inside && !stalled() ? *secant : std::sqrt(low_->tension * high_->tension);
    if (!secant) return last * (low_ ? kGrowth : 1.0 / kGrowth);
    return std::clamp(*secant, last / kMaxFactor, last * kMaxFactor);
  }

  /// Zero of the miss through the last two solutions, or through the last one with the slope of the initial shape.
  std::optional<double> secant_tension() const {
    const Trial &before = solved_[0], &last = solved_[1];
    if (!last.miss) return std::nullopt;
    const double slope =
        before.miss ? (*last.miss - *before.miss) / (last.tension - before.tension) : shape_slope(last.tension);
    if (!(slope > 0.0)) return std::nullopt;
    return last.tension - *last.miss / slope;
  }

  double shape_slope(double tension) const {
    constexpr double kStep = 0.01;
    const double length = *model_.description.pipe.length;
    const auto distance = [&](double pull) { return shape_distance(lay_shape(model_, plane_, pull), length); };
    return (distance((1.0 + kStep) * tension) - distance(tension)) / (kStep * tension);
  }

  /// True if three evaluations have not halved the bracket on a logarithmic scale: the secant converges slowly.
  bool stalled() {
    const double width = std::log(high_->tension / low_->tension);
    widths_ = {widths_[1], widths_[2], width};
    return widths_[0] > 0.0 && width > 0.5 * widths_[0];
  }

  /// Tension next to one without an equilibrium: towards the last solution, otherwise alternately above and below.
  double tension_near_failure(double tension) const {
    if (solved_[1].miss) return std::sqrt(tension * solved_[1].tension);
    return tension * (failures_ % 2 == 1 ? 1.15 : 0.8);
  }

  StaticFailure explain() const {
    const double length = *model_.description.pipe.length, anchor = *model_.description.pipe.anchor;
    const bool low_solved = low_ && low_->miss, high_solved = high_ && high_->miss;
    if (high_solved && low_ && !low_solved) {
      return {"the anchor is too near", "the far end",
              fmt::format("pipe.anchor is {}; with pipe.length of {} the bottom tension falls to zero at {}, and "
                          "nearer the pipe is in compression at the seabed: give a larger distance or less length",
                          shown_digits(anchor, "m", 6), shown_digits(length, "m", 6),
                          shown_digits(anchor + *high_->miss, "m", 6))};
    }
    if (low_solved && high_ && !high_solved) {
      return {"the anchor is too far", "the far end",
              fmt::format("pipe.anchor is {}; with pipe.length of {} the line touches the seabed only up to {}: give a "
                          "smaller distance or more length",
                          shown_digits(anchor, "m", 6), shown_digits(length, "m", 6),
                          shown_digits(anchor + *low_->miss, "m", 6))};
    }
    if (low_solved && high_solved) {
      return {"no equilibrium found with the far end at the anchor", "the far end",
              fmt::format("at a tension of {} the far end jumps from {} to {}, past pipe.anchor of {}",
                          shown_digits(low_->tension, "N", 6), shown_digits(anchor + *low_->miss, "m", 6),
                          shown_digits(anchor + *high_->miss, "m", 6), shown_digits(anchor, "m", 6))};
    }
    return failure_.value_or(StaticFailure{"no equilibrium found with the far end at the anchor", "the far end", ""});
  }

  const Model& model_;
  const LoadHistory& past_;
  Model pulled_;  ///< Same line with a given tension.
  LayPlane plane_;
  EquilibriumTarget target_;
  double tolerance_;  ///< [m]
  std::optional<StaticSolution> solution_;
  SolveReport report_;                    ///< Sum over all trials with solutions.
  std::optional<StaticFailure> failure_;  ///< Failure of the last trial.
  std::optional<Trial> low_, high_;       ///< Far end nearer and farther than the anchor.
  std::array<Trial, 2> solved_;           ///< Last two with solutions.
  std::array<double, 3> widths_{};
  std::optional<double> failed_at_;  ///< Tension of the last trial, if no equilibrium was found.
  int failures_ = 0;
};

}  // namespace

bool is_anchored(const Model& model) {
  return find_target(model.description).kind == EquilibriumTarget::Kind::anchor_distance &&
         !has_cable(model.description);
}

StaticOutcome solve_anchored(const Model& model, const LoadHistory& past) {
  return AnchorSearch(model, past).run();
}

}  // namespace overbend
