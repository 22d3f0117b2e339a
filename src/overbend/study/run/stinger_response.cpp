#include "study/run/stinger_response.h"

#include <algorithm>
#include <cmath>

#include "model/vessel/stinger_rotation.h"
#include "statics/stinger/stinger_equilibrium.h"

namespace overbend {
namespace {

constexpr double kStopTolerance = 1e-9;  ///< [rad]
constexpr double kMaxTurn = 1e-6;        ///< Turn for finite differences [rad].
constexpr double kMaxAsymmetry = 0.02;   ///< Relative difference of the two one-sided changes of moment beyond which
                                         ///< they are rounding of stiff contacts [-].

/// Returns the stop at which a section lies, from the limits of a description; the angle itself if it is at no stop.
double stop_angle(const StingerSectionDescription& limited, const StingerSectionDescription& rest, double angle) {
  if (!rest.limits || !limited.limits) return angle;
  if (std::abs(angle - rest.limits->down) < kStopTolerance) return limited.limits->down;
  if (std::abs(angle - rest.limits->up) < kStopTolerance) return limited.limits->up;
  return angle;
}

bool at_stop(const StingerSectionDescription& section, double angle) {
  return section.limits && (std::abs(angle - section.limits->down) < kStopTolerance ||
                            std::abs(angle - section.limits->up) < kStopTolerance);
}

}  // namespace

void set_stinger(Model& model, const Model& at_rest, const std::vector<double>& turns) {
  const std::vector<StingerSectionDescription>& described = model.description.supports.sections;
  const std::vector<StingerSectionDescription>& rest = at_rest.description.supports.sections;
  if (described.empty() || described.size() != at_rest.supports.sections.size()) return;
  std::vector<double> angles;
  for (std::size_t i = 0; i < described.size(); ++i) {
    const bool found = described[i].floats() && !described[i].angle;
    const double angle = at_rest.supports.sections[i].angle, turn = turns.empty() ? 0.0 : turns[i];
    angles.push_back(found ? stop_angle(described[i], rest[i], angle) + turn : described[i].angle.value_or(0.0));
  }
  rotate_stinger(model.supports, angles);
}

StingerResponse::StingerResponse(const Model& model, const StaticSolution& rest, EquilibriumTangent& pipe)
    : model_(model), rest_(&rest) {
  for (const std::size_t i : floating_sections(model.description.supports)) {
    if (!at_stop(model.description.supports.sections[i], model.supports.sections[i].angle)) free_.push_back(i);
  }
  const auto n = static_cast<Eigen::Index>(free_.size());
  Eigen::MatrixXd falls(n, n);
  for (Eigen::Index k = 0; k < n; ++k) {
    const std::optional<Eigen::VectorXd> fall = moment_decrease(free_[static_cast<std::size_t>(k)], pipe);
    if (!fall) {
      regular_ = false;
      return;
    }
    falls.col(k) = *fall;
  }
  if (n == 0) return;
  stiffness_falls_.compute(falls);
  regular_ = stiffness_falls_.rcond() > 1e-12;
}

/// Uses turns so small that no contact changes: stiff rollers are pressed in by less than a micrometre. Empty if the
/// difference is dominated by rounding.
std::optional<Eigen::VectorXd> StingerResponse::moment_decrease(std::size_t section, EquilibriumTangent& pipe) const {
  std::vector<double> turns(model_.supports.sections.size(), 0.0);
  constexpr int kTries = 6;
  for (int i = 0; i < kTries; ++i) {
    const double turn = std::pow(0.1, i) * kMaxTurn;
    Model up = model_, down = model_;
    turns[section] = -turn;
    set_stinger(up, model_, turns);
    turns[section] = turn;
    set_stinger(down, model_, turns);
    const std::optional<StaticPair> pair = pipe.neighbouring_equilibria(up, down);
    if (!pair) return std::nullopt;
    if (!pair->contacts_stay) continue;
    const Eigen::VectorXd at_rest = moments(model_, *rest_), above = moments(up, pair->before) - at_rest,
                          below = at_rest - moments(down, pair->after);
    if ((above - below).norm() > kMaxAsymmetry * (above + below).norm()) return std::nullopt;
    return (above + below) / (2.0 * turn);
  }
  return std::nullopt;
}

Eigen::VectorXd StingerResponse::moments(const Model& model, const StaticSolution& solution) const {
  StaticSystem system = system_with_history(model, solution.mesh, solution.past);
  system.evaluate(solution.state, false);
  const std::vector<double> all = hinge_moments(model, pipe_on_sections(system));
  Eigen::VectorXd free(static_cast<Eigen::Index>(free_.size()));
  for (Eigen::Index k = 0; k < free.size(); ++k) free(k) = all[free_[static_cast<std::size_t>(k)]];
  return free;
}

Eigen::VectorXd StingerResponse::moments(std::size_t section, const PointForce& force) const {
  Eigen::VectorXd free = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(free_.size()));
  for (Eigen::Index k = 0; k < free.size(); ++k) {
    const std::size_t hinge = free_[static_cast<std::size_t>(k)];
    if (hinge <= section) free(k) = moment_about(hinge_axis(model_, hinge), {force});
  }
  return free;
}

std::vector<double> StingerResponse::compensating_turns(const Eigen::VectorXd& change) const {
  std::vector<double> turns(model_.supports.sections.size(), 0.0);
  const Eigen::VectorXd free = stiffness_falls_.solve(change);
  for (Eigen::Index k = 0; k < free.size(); ++k) turns[free_[static_cast<std::size_t>(k)]] = free(k);
  return turns;
}

}  // namespace overbend
