#include "statics/stinger/stinger_search.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/constants.h"
#include "base/shown_unit.h"
#include "model/vessel/stinger_turn.h"

namespace overbend {
namespace {

constexpr double kBalanced = 2e-8;  ///< Of a moment, over what is added up in it.
constexpr double kFirstStep = 2.0 * kDegree;
constexpr double kLongestStep = 8.0 * kDegree;
constexpr double kShortestStep = 1e-9;  ///< [rad]
constexpr double kOvershoot = 0.5;      ///< Of the moment along a step, turned round at its end: the step is shortened.
constexpr int kMostTrials = 120;
constexpr double kLook = 1e-5;                                         ///< For differences [rad].
constexpr double kTries[] = {0.0, 3.0, -3.0, 6.0, -6.0, 12.0, -12.0};  ///< Angles to begin at [deg].

double magnitudes(const HingeAxis& hinge, const std::vector<PointForce>& forces) {
  double sum = 0.0;
  for (const PointForce& force : forces) sum += (force.at_W - hinge.at_W).norm() * force.force_W.norm();
  return sum;
}

}  // namespace

StingerSearch::StingerSearch(Model& model, const LinePast& past, std::vector<std::size_t> floating,
                             std::vector<double> wanted)
    : model_(model), past_(past), floating_(std::move(floating)) {
  const auto n = static_cast<Eigen::Index>(floating_.size());
  wanted_ = Eigen::VectorXd::Zero(n);
  low_ = Eigen::VectorXd::Constant(n, -kFurthestTurn);
  high_ = Eigen::VectorXd::Constant(n, kFurthestTurn);
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

Eigen::VectorXd StingerSearch::of_floating(const std::vector<double>& angles) const {
  Eigen::VectorXd own(static_cast<Eigen::Index>(floating_.size()));
  for (Eigen::Index i = 0; i < own.size(); ++i) own[i] = angles[floating_[static_cast<std::size_t>(i)]];
  return own;
}

std::optional<StingerTrial> StingerSearch::at(const Eigen::VectorXd& angles) {
  ++trials_;
  for (std::size_t k = 0; k < floating_.size(); ++k) {
    angles_[floating_[k]] = angles[static_cast<Eigen::Index>(k)];
  }
  turn_stinger(model_.supports, angles_);
  StaticOutcome outcome = solve_statics(model_, last_ && !afresh_ ? &*last_ : nullptr, past_);
  if (outcome.failure) {
    if (!pipe_failure_) pipe_failure_ = std::move(outcome.failure);
    return std::nullopt;
  }
  StingerTrial trial{angles, {}, {}, std::move(*outcome.solution)};
  StaticSystem system = system_with_past(model_, trial.solution.mesh, past_);
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

/// At the angles given, or at others where the pipe has no equilibrium there: the first section turns with all the
/// rest.
bool StingerSearch::begin(const Eigen::VectorXd& from) {
  for (const double offset : kTries) {
    Eigen::VectorXd angles = from;
    angles[0] += offset * kDegree;
    if (offset != 0.0 && clipped(angles) != angles) continue;
    now_ = at(clipped(angles));
    if (now_) return true;
  }
  return false;
}

Eigen::VectorXd StingerSearch::lack(const StingerTrial& trial) const {
  return trial.moments - wanted_;
}

/// Those that no stop holds against the moment.
std::vector<int> StingerSearch::free_ones(const StingerTrial& trial) const {
  std::vector<int> free;
  const Eigen::VectorXd moment = lack(trial);
  for (int i = 0; i < static_cast<int>(moment.size()); ++i) {
    const bool stopped =
        (trial.angles[i] >= high_[i] && moment[i] >= 0.0) || (trial.angles[i] <= low_[i] && moment[i] <= 0.0);
    if (!stopped) free.push_back(i);
  }
  return free;
}

bool StingerSearch::at_rest(const StingerTrial& trial, const std::vector<int>& free) const {
  const Eigen::VectorXd moment = lack(trial);
  return std::all_of(free.begin(), free.end(),
                     [&](int i) { return std::abs(moment[i]) <= kBalanced * trial.scale[i]; });
}

/// Newton's with what is known of the stiffness, or straight along the moments; not longer than a step may be.
Eigen::VectorXd StingerSearch::direction(const std::vector<int>& free) const {
  const Eigen::VectorXd moment = lack(*now_);
  const Eigen::MatrixXd part = stiffness_(free, free);
  const Eigen::VectorXd along = moment(free);
  const auto limited = [&](const Eigen::VectorXd& inner) {
    Eigen::VectorXd way = Eigen::VectorXd::Zero(moment.size());
    way(free) = inner * std::min(1.0, longest_ / inner.cwiseAbs().maxCoeff());
    return Eigen::VectorXd(clipped(now_->angles + way) - now_->angles);
  };
  const Eigen::LLT<Eigen::MatrixXd> factors(part);
  if (factors.info() == Eigen::Success) {
    Eigen::VectorXd way = limited(factors.solve(along));
    if (way.dot(moment) > 0.0) return way;
  }
  return limited(along.cwiseQuotient(now_->scale(free)));
}

/// Lets the stiffness have the change of moments that was seen, as far as it stays positive definite; where moments
/// grow along the way, it is softer than was thought.
void StingerSearch::learn(const StingerTrial& before, const StingerTrial& after) {
  const Eigen::VectorXd s = after.angles - before.angles, y = before.moments - after.moments;
  const double sy = s.dot(y);
  if (!(sy > 1e-6 * s.norm() * y.norm())) {
    stiffness_ *= 0.5;
    return;
  }
  const Eigen::VectorXd known = stiffness_ * s;
  stiffness_ += y * y.transpose() / sy - known * known.transpose() / s.dot(known);
}

/// Solutions that start from each other may lie on two branches, between which the moment jumps: from here on, each
/// trial starts from nothing. A jump that is left then is the pipe's.
bool StingerSearch::begin_afresh(const StingerTrial& from) {
  jumps_ = afresh_;
  if (afresh_) return false;
  afresh_ = true;
  trials_ = 0;
  longest_ = kFirstStep;
  std::optional<StingerTrial> again = at(from.angles);
  if (!again) return false;
  now_ = std::move(again);
  return true;
}

/// The moment along the way turns round before its end: closes in on where (Illinois: Dowell and Jarratt 1971).
bool StingerSearch::shorten(const Eigen::VectorXd& way, double slope, double share, StingerTrial beyond) {
  const StingerTrial from = *now_;
  double low = 0.0, high = share, at_low = slope, at_high = lack(beyond).dot(way);
  int side = 0;
  StingerTrial nearest = std::move(beyond);
  while (std::abs(lack(nearest).dot(way)) > kOvershoot * slope) {
    if ((high - low) * way.cwiseAbs().maxCoeff() < kShortestStep || trials_ > kMostTrials) {
      return begin_afresh(from);
    }
    const double next = low + (high - low) * std::clamp(at_low / (at_low - at_high), 0.05, 0.95);
    std::optional<StingerTrial> trial = at(from.angles + next * way);
    if (!trial) return false;
    const double along = lack(*trial).dot(way);
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
  learn(from, nearest);
  now_ = std::move(nearest);
  return true;
}

bool StingerSearch::step(const std::vector<int>& free) {
  const Eigen::VectorXd way = direction(free);
  const double slope = lack(*now_).dot(way);
  double share = 1.0;
  std::optional<StingerTrial> next = at(now_->angles + way);
  while (!next) {
    share *= 0.5;
    longest_ *= 0.5;
    if (share < 0.01) return false;
    last_ = now_->solution;
    next = at(now_->angles + share * way);
  }
  const double after = lack(*next).dot(way);
  if (after < -kOvershoot * slope) {
    longest_ = std::max(0.5 * longest_, kShortestStep);
    return shorten(way, slope, share, std::move(*next));
  }
  if (after > kOvershoot * slope) longest_ = std::min(2.0 * longest_, kLongestStep);
  learn(*now_, *next);
  now_ = std::move(next);
  return true;
}

/// No stop holds it, only the end of the range that is looked at.
bool StingerSearch::turned_too_far() const {
  for (std::size_t k = 0; k < floating_.size(); ++k) {
    const bool stops = model_.description.supports.sections[floating_[k]].limits.has_value();
    if (!stops && std::abs(now_->angles[static_cast<Eigen::Index>(k)]) >= kFurthestTurn) return true;
  }
  return false;
}

StaticFailure StingerSearch::failure() const {
  if (!now_) return *pipe_failure_;
  const Eigen::VectorXd left = lack(*now_);
  Eigen::Index worst = 0;
  Eigen::VectorXd share = left.cwiseAbs().cwiseQuotient(now_->scale);
  for (Eigen::Index i = 0; i < share.size(); ++i) {
    const auto& limits = model_.description.supports.sections[floating_[static_cast<std::size_t>(i)]].limits;
    if (limits && (now_->angles[i] >= high_[i] || now_->angles[i] <= low_[i])) share[i] *= 1e-9;  // its stop holds it
  }
  share.maxCoeff(&worst);
  const std::size_t section = floating_[static_cast<std::size_t>(worst)];
  const std::string& name = model_.description.supports.sections[section].name;
  const std::string where = name.empty() ? std::string("the stinger") : "stinger section '" + name + "'";
  const double angle = now_->angles[worst] / kDegree, moment = left[worst];
  if (jumps_) {
    return {"the stinger finds no rest", where,
            fmt::format("near an angle of {:.2f} deg the moment about its hinge jumps from one sign to the other: the "
                        "pipe changes its contacts there",
                        angle)};
  }
  std::string why = fmt::format("at an angle of {:.2f} deg a moment of {} about its hinge still turns the tip {}",
                                angle, shown(std::abs(moment), "N m", 0), moment > 0.0 ? "down" : "up");
  if (pipe_failure_) {
    why += fmt::format(", and beyond that the pipe has no equilibrium ({})", pipe_failure_->what);
  } else {
    why += ": weight, buoyancy and pipe do not balance; give more or less buoyancy, or limits";
  }
  return {"no equilibrium of the stinger found", where, why};
}

StaticOutcome StingerSearch::find(const std::vector<double>& angles, const StaticSolution* start,
                                  const std::vector<double>& stiffness) {
  angles_ = angles;
  const auto n = static_cast<Eigen::Index>(floating_.size());
  if (start != nullptr) last_ = *start;
  longest_ = kFirstStep;
  if (!begin(clipped(of_floating(angles)))) return {std::nullopt, failure()};
  stiffness_ = now_->scale.asDiagonal();
  if (static_cast<Eigen::Index>(stiffness.size()) == n * n) {
    stiffness_ = Eigen::Map<const Eigen::MatrixXd>(stiffness.data(), n, n);
  }
  for (std::vector<int> free = free_ones(*now_); !at_rest(*now_, free); free = free_ones(*now_)) {
    if (trials_ > kMostTrials || !step(free)) return {std::nullopt, failure()};
  }
  if (turned_too_far()) return {std::nullopt, failure()};
  for (std::size_t k = 0; k < floating_.size(); ++k) {
    angles_[floating_[k]] = now_->angles[static_cast<Eigen::Index>(k)];
  }
  turn_stinger(model_.supports, angles_);
  StaticSolution found = std::move(now_->solution);
  found.stinger.angles = angles_;
  found.stinger.stiffness.assign(stiffness_.data(), stiffness_.data() + stiffness_.size());
  return {std::move(found), std::nullopt};
}

std::optional<Eigen::MatrixXd> StingerSearch::stiffness(const std::vector<double>& angles,
                                                        const StaticSolution& solution) {
  angles_ = angles;
  const Eigen::VectorXd here = of_floating(angles);
  const Eigen::Index n = here.size();
  Eigen::MatrixXd falls(n, n);
  for (Eigen::Index i = 0; i < n; ++i) {
    const Eigen::VectorXd look = kLook * Eigen::VectorXd::Unit(n, i);
    last_ = solution;
    const std::optional<StingerTrial> up = at(here - look);
    last_ = solution;
    const std::optional<StingerTrial> down = at(here + look);
    if (!up || !down) return std::nullopt;
    falls.col(i) = (up->moments - down->moments) / (2.0 * kLook);
  }
  return falls;
}

}  // namespace overbend
