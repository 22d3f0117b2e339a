/// Response of a floating stinger's sections to a small change of the lay: docs/theory/sensitivities.md.
#pragma once

#include <optional>
#include <vector>

#include "base/vec.h"
#include "model/model.h"
#include "statics/solver/sensitivity.h"
#include "statics/stinger/stinger_forces.h"

namespace overbend {

/// Sets the section angles of `model` to those of `at_rest`, with floating sections turned further by `turns` [rad],
/// one per section, all zero if empty. A section at a stop is set to the stop of `model`.
void set_stinger(Model& model, const Model& at_rest, const std::vector<double>& turns = {});

class StingerResponse {
 public:
  /// Response of a lay in equilibrium with the tangent `pipe`; all arguments must outlive this. The pipe's part of the
  /// moment stiffness is found by following the equilibrium through two small turns of each section.
  StingerResponse(const Model& model, const StaticSolution& rest, EquilibriumTangent& pipe);

  /// True if any section can turn: one that floats and is at no stop.
  bool turns() const { return !free_.empty(); }
  /// False if the moments do not hold the stinger in place, so that it is about to turn over, or if rollers are so
  /// stiff that their forces are too inaccurate.
  bool regular() const { return regular_; }

  /// Moments about the hinges of the free sections, positive when they turn the tip down [N m].
  Eigen::VectorXd moments(const Model& model, const StaticSolution& solution) const;
  /// Returns the moments of a force on a section about these hinges [N m].
  Eigen::VectorXd moments(std::size_t section, const PointForce& force) const;
  /// Returns the turns of all sections that cancel a change of these moments [rad].
  std::vector<double> compensating_turns(const Eigen::VectorXd& change) const;

 private:
  std::optional<Eigen::VectorXd> moment_decrease(std::size_t section, EquilibriumTangent& pipe) const;

  const Model& model_;
  const StaticSolution* rest_;
  std::vector<std::size_t> free_;
  Eigen::PartialPivLU<Eigen::MatrixXd> stiffness_falls_;  ///< Decrease of the moments with the angles [N m/rad].
  bool regular_ = true;
};

}  // namespace overbend
