#include "statics/solver/step_mixing.h"

#include <utility>

namespace overbend {
namespace {

constexpr std::size_t kMixed = 6;      ///< Number of stored steps; 3 to 10 solve about as many random lays.
constexpr double kMaxRemainder = 0.7;  ///< Maximum remaining share of a step for which it is mixed.

Eigen::VectorXd joined(const std::vector<double>& step, double share, double force) {
  Eigen::VectorXd all(static_cast<Eigen::Index>(step.size()) + 1);
  all << share * Eigen::Map<const Eigen::VectorXd>(step.data(), static_cast<Eigen::Index>(step.size())), force;
  return all;
}

}  // namespace

void StepMixing::mix(std::vector<double>& step, double& force) {
  Eigen::VectorXd mixed = joined(step, 1.0, force);
  if (asked_.size() == mixed.size() && taken_.size() == mixed.size()) {
    if (changes_.size() == kMixed) changes_.erase(changes_.begin());
    changes_.push_back({mixed - asked_, taken_});
  }
  asked_ = mixed;
  taken_.resize(0);
  if (changes_.empty()) return;
  Eigen::MatrixXd change(mixed.size(), static_cast<Eigen::Index>(changes_.size()));
  for (std::size_t i = 0; i < changes_.size(); ++i) change.col(static_cast<Eigen::Index>(i)) = changes_[i].asked;
  const Eigen::VectorXd share = least_squares(change, mixed);
  if ((mixed - change * share).norm() > kMaxRemainder * mixed.norm()) return;
  for (std::size_t i = 0; i < changes_.size(); ++i) {
    mixed -= share(static_cast<Eigen::Index>(i)) * (changes_[i].asked + changes_[i].taken);
  }
  Eigen::Map<Eigen::VectorXd>(step.data(), mixed.size() - 1) = mixed.head(mixed.size() - 1);
  force = mixed(mixed.size() - 1);
}

void StepMixing::record_taken(const std::vector<double>& step, double share, double force) {
  taken_ = joined(step, share, force);
}

void StepMixing::forget() {
  changes_.clear();
  asked_.resize(0);
  taken_.resize(0);
}

}  // namespace overbend
