/// How the sections of a stinger that finds its own angle follow a small change of the lay:
/// docs/theory/sensitivities.md.
#pragma once

#include <optional>
#include <vector>

#include "base/vec.h"
#include "model/model.h"
#include "statics/solver/sensitivity.h"
#include "statics/stinger/stinger_forces.h"

namespace overbend {

/// Turns the sections of a stinger as `at_rest` has them, floating ones further by `turns` [rad], one for each section,
/// all zero where empty. A section at a stop lies at the stop of `model`.
void set_stinger(Model& model, const Model& at_rest, const std::vector<double>& turns = {});

class StingerResponse {
 public:
  /// Of a lay at rest, whose tangent is `pipe`; all must outlive this. The pipe's part of the moments' stiffness is
  /// found by following the equilibrium to two small turns of each section.
  StingerResponse(const Model& model, const StaticSolution& rest, EquilibriumTangent& pipe);

  /// Whether any section may turn: one that floats, at no stop.
  bool turns() const { return !free_.empty(); }
  /// False where the moments do not hold the stinger in place: it is about to turn over; and where rollers are so stiff
  /// that their forces are known too coarsely.
  bool regular() const { return regular_; }

  /// Moments about the hinges of the free sections, positive when they turn the tip down [N m].
  Eigen::VectorXd moments(const Model& model, const StaticSolution& solution) const;
  /// Moments of a force on a section.
  Eigen::VectorXd moments(std::size_t section, const PointForce& force) const;
  /// The turns of all sections that take a change of these moments away [rad].
  std::vector<double> answer(const Eigen::VectorXd& change) const;

 private:
  std::optional<Eigen::VectorXd> fall_with(std::size_t section, EquilibriumTangent& pipe) const;

  const Model& model_;
  const StaticSolution* rest_;
  std::vector<std::size_t> free_;
  Eigen::PartialPivLU<Eigen::MatrixXd> falls_;  ///< Fall of the moments with the angles [N m/rad].
  bool regular_ = true;
};

}  // namespace overbend
