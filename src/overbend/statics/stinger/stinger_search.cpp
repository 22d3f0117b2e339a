#include "statics/stinger/stinger_search.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/constants.h"
#include "base/shown_unit.h"
#include "model/vessel/stinger_rotation.h"

namespace overbend {
namespace {

constexpr double kBalanced = 2e-8;  ///< Tolerance of a moment relative to the sum of its contributions.
constexpr double kFirstStep = 2.0 * kDegree;
constexpr double kMaxStep = 8.0 * kDegree;
constexpr double kMinStep = 1e-9;   ///< [rad]
constexpr double kOvershoot = 0.5;  ///< Share of the moment along a step whose reversal at the end of the step
                                    ///< shortens it.
constexpr int kMaxTrials = 120;
constexpr double kDifference = 1e-5;  ///< Step of finite differences [rad].
constexpr double kStartOffsets[] = {0.0,  3.0,  -3.0, 6.0,
                                    -6.0, 12.0, -12.0};  ///< Offsets of the first angle that are tried at
                                                         ///< the start [deg].

double magnitudes(const HingeAxis& hinge, const std::vector<PointForce>& forces) {
  double sum = 0.0;
  for (const PointForce& force : forces) sum += (force.at_W - hinge.at_W).norm() * force.force_W.norm();
  return sum;
}

}  // namespace

StingerSearch::StingerSearch(Model& model, const LoadHistory& past, std::vector<std::size_t> floating,
                             std::vector<double> wanted)
    : model_(model), past_(past), floating_(std::move(floating)) {
  const auto n = static_cast<Eigen::Index>(floating_.size());
  wanted_ = Eigen::VectorXd::Zero(n);
  low_ = Eigen::VectorXd::Constant(n, -kMaxStingerAngle);
  high_ = Eigen::VectorXd::Constant(n, kMaxStingerAngle);
  for (Eigen::Index i = 0; i < n; ++i) {
    const std::size_t k = static_cast<std::size_t>(i);
    if (!wanted.empty()) wanted_[i] = wanted[k];
    const std::optional<StingerLimits>& limits = model.description.supports.sections[floating_[k]].limits;
    if (limits) {
      low_[i] = limits->up;
      high_[i] = limits->down;
    }
  }
}

Eigen::VectorXd StingerSearch::clipped(const Eigen::VectorXd& angles) const {
  return angles.cwiseMax(low_).cwiseMin(high_);
}

Eigen::VectorXd StingerSearch::select_floating(const std::vector<double>& angles) const {
  Eigen::VectorXd floating_angles(static_cast<Eigen::Index>(floating_.size()));
  for (Eigen::Index i = 0; i < floating_angles.size(); ++i) {
    floating_angles[i] = angles[floating_[static_cast<std::size_t>(i)]];
  }
  return floating_angles;
}

std::optional<StingerTrial> StingerSearch::solve_at(const Eigen::VectorXd& angles) {
  ++trials_;
  for (std::size_t k = 0; k < floating_.size(); ++k) {
    angles_[floating_[k]] = angles[static_cast<Eigen::Index>(k)];
  }
  rotate_stinger(model_.supports, angles_);
  StaticOutcome outcome = solve_statics(model_, last_ && !cold_ ? &*last_ : nullptr, past_);
  if (outcome.failure) {
    if (!pipe_failure_) pipe_failure_ = std::move(outcome.failure);
    return std::nullopt;
  }
  StingerTrial trial{angles, {}, {}, std::move(*outcome.solution)};
  StaticSystem system = system_with_history(model_, trial.solution.mesh, past_);
  system.evaluate(trial.solution.state, false);
  const std::vector<std::vector<PointForce>> pipe = pipe_on_sections(system);
  const std::vector<double> moments = hinge_moments(model_, pipe);
  trial.moments = trial.scale = Eigen::VectorXd::Zero(angles.size());
  for (std::size_t k = 0; k < floating_.size(); ++k) {
    const auto i = static_cast<Eigen::Index>(k);
    trial.moments[i] = moments[floating_[k]];
    const HingeAxis hinge = hinge_axis(model_, floating_[k]);
    for (std::size_t behind = floating_[k]; behind < pipe.size(); ++behind) {
      trial.scale[i] += magnitudes(hinge, pipe[behind]) + magnitudes(hinge, section_forces(model_, behind));
    }
  }
  last_ = trial.solution;
  return trial;
}

/// Starts at the given angles, or at others if the pipe has no equilibrium there: the first section turns with all
/// those behind it.
bool StingerSearch::begin(const Eigen::VectorXd& from) {
  for (const double offset : kStartOffsets) {
    Eigen::VectorXd angles = from;
    angles[0] += offset * kDegree;
    if (offset != 0.0 && clipped(angles) != angles) continue;
    current_ = solve_at(clipped(angles));
    if (current_) return true;
  }
  return false;
}

Eigen::VectorXd StingerSearch::unbalanced_moment(const StingerTrial& trial) const {
  return trial.moments - wanted_;
}

/// Sections that no stop holds against the moment.
std::vector<int> StingerSearch::free_sections(const StingerTrial& trial) const {
  std::vector<int> free;
  const Eigen::VectorXd moment = unbalanced_moment(trial);
  for (int i = 0; i < static_cast<int>(moment.size()); ++i) {
    const bool stopped =
        (trial.angles[i] >= high_[i] && moment[i] >= 0.0) || (trial.angles[i] <= low_[i] && moment[i] <= 0.0);
    if (!stopped) free.push_back(i);
  }
  return free;
}

bool StingerSearch::is_balanced(const StingerTrial& trial, const std::vector<int>& free) const {
  const Eigen::VectorXd moment = unbalanced_moment(trial);
  return std::all_of(free.begin(), free.end(),
                     [&](int i) { return std::abs(moment[i]) <= kBalanced * trial.scale[i]; });
}

/// Newton direction with the present stiffness, or steepest descent; limited to the maximum step.
Eigen::VectorXd StingerSearch::direction(const std::vector<int>& free) const {
  const Eigen::VectorXd moment = unbalanced_moment(*current_);
  const Eigen::MatrixXd part = stiffness_(free, free);
  const Eigen::VectorXd along = moment(free);
  const auto limited = [&](const Eigen::VectorXd& inner) {
    Eigen::VectorXd increment = Eigen::VectorXd::Zero(moment.size());
    increment(free) = inner * std::min(1.0, max_step_ / inner.cwiseAbs().maxCoeff());
    return Eigen::VectorXd(clipped(current_->angles + increment) - current_->angles);
  };
  const Eigen::LLT<Eigen::MatrixXd> factors(part);
  if (factors.info() == Eigen::Success) {
    Eigen::VectorXd increment = limited(factors.solve(along));
    if (increment.dot(moment) > 0.0) return increment;
  }
  return limited(along.cwiseQuotient(current_->scale(free)));
}

/// Updates the stiffness with the observed change of moments, as far as it stays positive definite; halves it if
/// moments grow along the step.
void StingerSearch::update_stiffness(const StingerTrial& before, const StingerTrial& after) {
  const Eigen::VectorXd s = after.angles - before.angles, y = before.moments - after.moments;
  const double sy = s.dot(y);
  if (!(sy > 1e-6 * s.norm() * y.norm())) {
    stiffness_ *= 0.5;
    return;
  }
  const Eigen::VectorXd known = stiffness_ * s;
  stiffness_ += y * y.transpose() / sy - known * known.transpose() / s.dot(known);
}

/// Solutions with warm starts may lie on two branches between which the moment jumps: from here on each trial starts
/// without one. A jump that remains is physical.
bool StingerSearch::restart_cold(const StingerTrial& from) {
  jumps_ = cold_;
  if (cold_) return false;
  cold_ = true;
  trials_ = 0;
  max_step_ = kFirstStep;
  std::optional<StingerTrial> again = solve_at(from.angles);
  if (!again) return false;
  current_ = std::move(again);
  return true;
}

/// The moment along the step changes sign before its end: find the zero (Illinois: Dowell and Jarratt 1971).
bool StingerSearch::shorten(const Eigen::VectorXd& increment, double slope, double share, StingerTrial beyond) {
  const StingerTrial from = *current_;
  double low = 0.0, high = share, at_low = slope, at_high = unbalanced_moment(beyond).dot(increment);
  int side = 0;
  StingerTrial nearest = std::move(beyond);
  while (std::abs(unbalanced_moment(nearest).dot(increment)) > kOvershoot * slope) {
    if ((high - low) * increment.cwiseAbs().maxCoeff() < kMinStep || trials_ > kMaxTrials) {
      return restart_cold(from);
    }
    const double next = low + (high - low) * std::clamp(at_low / (at_low - at_high), 0.05, 0.95);
    std::optional<StingerTrial> trial = solve_at(from.angles + next * increment);
    if (!trial) return false;
    const double along = unbalanced_moment(*trial).dot(increment);
    if (along > 0.0) {
      low = next;
      at_low = along;
      if (side == 1) at_high *= 0.5;
      side = 1;
    } else {
      high = next;
      at_high = along;
      if (side == -1) at_low *= 0.5;
      side = -1;
    }
    nearest = std::move(*trial);
  }
  update_stiffness(from, nearest);
  current_ = std::move(nearest);
  return true;
}

bool StingerSearch::step(const std::vector<int>& free) {
  const Eigen::VectorXd full_step = direction(free);
  const double slope = unbalanced_moment(*current_).dot(full_step);
  double share = 1.0;
  std::optional<StingerTrial> next = solve_at(current_->angles + full_step);
  while (!next) {
    share *= 0.5;
    max_step_ *= 0.5;
    if (share < 0.01) return false;
    last_ = current_->solution;
    next = solve_at(current_->angles + share * full_step);
  }
  const double after = unbalanced_moment(*next).dot(full_step);
  if (after < -kOvershoot * slope) {
    max_step_ = std::max(0.5 * max_step_, kMinStep);
    return shorten(full_step, slope, share, std::move(*next));
  }
  if (after > kOvershoot * slope) max_step_ = std::min(2.0 * max_step_, kMaxStep);
  update_stiffness(*current_, *next);
  current_ = std::move(next);
  return true;
}

/// True if a section is at the end of the search range without a stop.
bool StingerSearch::turned_too_far() const {
  for (std::size_t k = 0; k < floating_.size(); ++k) {
    const bool stops = model_.description.supports.sections[floating_[k]].limits.has_value();
    if (!stops && std::abs(current_->angles[static_cast<Eigen::Index>(k)]) >= kMaxStingerAngle) return true;
  }
  return false;
}

StaticFailure StingerSearch::failure() const {
  if (!current_) return *pipe_failure_;
  const Eigen::VectorXd left = unbalanced_moment(*current_);
  Eigen::Index worst = 0;
  Eigen::VectorXd share = left.cwiseAbs().cwiseQuotient(current_->scale);
  for (Eigen::Index i = 0; i < share.size(); ++i) {
    const auto& limits = model_.description.supports.sections[floating_[static_cast<std::size_t>(i)]].limits;
    if (limits && (current_->angles[i] >= high_[i] || current_->angles[i] <= low_[i])) {
      share[i] *= 1e-9;
    }  // held by its stop
  }
  share.maxCoeff(&worst);
  const std::size_t section = floating_[static_cast<std::size_t>(worst)];
  const std::string& name = model_.description.supports.sections[section].name;
  const std::string where = name.empty() ? std::string("the stinger") : "stinger section '" + name + "'";
  const double angle = current_->angles[worst] / kDegree, moment = left[worst];
  if (jumps_) {
    return {"no equilibrium of the stinger found", where,
            fmt::format("near an angle of {:.2f} deg the moment about its hinge changes sign abruptly: the pipe "
                        "changes its contacts there",
                        angle)};
  }
  std::string why =
      fmt::format("at an angle of {:.2f} deg a moment of {} about its hinge is unbalanced and turns the tip {}", angle,
                  shown(std::abs(moment), "N m", 0), moment > 0.0 ? "down" : "up");
  if (pipe_failure_) {
    why += fmt::format(", and beyond that the pipe has no equilibrium ({})", pipe_failure_->what);
  } else {
    why += ": weight, buoyancy and pipe do not balance; change the buoyancy, or give limits";
  }
  return {"no equilibrium of the stinger found", where, why};
}

StaticOutcome StingerSearch::find(const std::vector<double>& angles, const StaticSolution* start,
                                  const std::vector<double>& stiffness) {
  angles_ = angles;
  const auto n = static_cast<Eigen::Index>(floating_.size());
  if (start != nullptr) last_ = *start;
  max_step_ = kFirstStep;
  if (!begin(clipped(select_floating(angles)))) return {std::nullopt, failure()};
  stiffness_ = current_->scale.asDiagonal();
  if (static_cast<Eigen::Index>(stiffness.size()) == n * n) {
    stiffness_ = Eigen::Map<const Eigen::MatrixXd>(stiffness.data(), n, n);
  }
  for (std::vector<int> free = free_sections(*current_); !is_balanced(*current_, free);
       free = free_sections(*current_)) {
    if (trials_ > kMaxTrials || !step(free)) return {std::nullopt, failure()};
  }
  if (turned_too_far()) return {std::nullopt, failure()};
  for (std::size_t k = 0; k < floating_.size(); ++k) {
    angles_[floating_[k]] = current_->angles[static_cast<Eigen::Index>(k)];
  }
  rotate_stinger(model_.supports, angles_);
  StaticSolution found = std::move(current_->solution);
  found.stinger.angles = angles_;
  found.stinger.stiffness.assign(stiffness_.data(), stiffness_.data() + stiffness_.size());
  return {std::move(found), std::nullopt};
}

std::optional<Eigen::MatrixXd> StingerSearch::stiffness(const std::vector<double>& angles,
                                                        const StaticSolution& solution) {
  angles_ = angles;
  const Eigen::VectorXd floating_angles = select_floating(angles);
  const Eigen::Index n = floating_angles.size();
  Eigen::MatrixXd falls(n, n);
  for (Eigen::Index i = 0; i < n; ++i) {
    const Eigen::VectorXd look = kDifference * Eigen::VectorXd::Unit(n, i);
    last_ = solution;
    const std::optional<StingerTrial> up = solve_at(floating_angles - look);
    last_ = solution;
    const std::optional<StingerTrial> down = solve_at(floating_angles + look);
    if (!up || !down) return std::nullopt;
    falls.col(i) = (up->moments - down->moments) / (2.0 * kDifference);
  }
  return falls;
}

}  // namespace overbend
