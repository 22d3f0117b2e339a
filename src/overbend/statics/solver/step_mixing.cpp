#include "statics/solver/step_mixing.h"

#include <utility>

namespace overbend {
namespace {

constexpr std::size_t kMixed = 6;    ///< Steps that are remembered; 3 to 10 solve about as many random lays.
constexpr double kWorthwhile = 0.7;  ///< Share of a step that may stand against those before and still be mixed.

Eigen::VectorXd joined(const std::vector<double>& step, double share, double force) {
  Eigen::VectorXd all(static_cast<Eigen::Index>(step.size()) + 1);
  all << share * Eigen::Map<const Eigen::VectorXd>(step.data(), static_cast<Eigen::Index>(step.size())), force;
  return all;
}

}  // namespace

void StepMixing::mix(std::vector<double>& step, double& force) {
  Eigen::VectorXd now = joined(step, 1.0, force);
  if (asked_.size() == now.size() && taken_.size() == now.size()) {
    if (changes_.size() == kMixed) changes_.erase(changes_.begin());
    changes_.push_back({now - asked_, taken_});
  }
  asked_ = now;
  taken_.resize(0);
  if (changes_.empty()) return;
  Eigen::MatrixXd change(now.size(), static_cast<Eigen::Index>(changes_.size()));
  for (std::size_t i = 0; i < changes_.size(); ++i) change.col(static_cast<Eigen::Index>(i)) = changes_[i].asked;
  const Eigen::VectorXd share = least_squares(change, now);
  if ((now - change * share).norm() > kWorthwhile * now.norm()) return;
  for (std::size_t i = 0; i < changes_.size(); ++i) {
    now -= share(static_cast<Eigen::Index>(i)) * (changes_[i].asked + changes_[i].taken);
  }
  Eigen::Map<Eigen::VectorXd>(step.data(), now.size() - 1) = now.head(now.size() - 1);
  force = now(now.size() - 1);
}

void StepMixing::took(const std::vector<double>& step, double share, double force) {
  taken_ = joined(step, share, force);
}

void StepMixing::forget() {
  changes_.clear();
  asked_.resize(0);
  taken_.resize(0);
}

}  // namespace overbend
