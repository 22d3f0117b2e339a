/// Equations of static equilibrium of a system, or of one of its lines alone.
///
/// Unknowns: position and tangent of every node, poses of free bodies, and the force that holds a far end along the
/// bed, with a target as its equation. Positions keep digits beyond a double (LineState::low).
#pragma once

#include "statics/equations/equilibrium_target.h"
#include "statics/equations/far_end.h"
#include "system/assembly.h"

namespace overbend {

/// Sets `to` = `from` + share * dq, with digits beyond a double in `low` (two-sum, Knuth 1969).
void advance(LineState& to, const LineState& from, const std::vector<double>& dq, double share);

/// Friction history of an equilibrium.
struct EquilibriumRule {
  LayHistory history = LayHistory::monotonic;  ///< Laying history, for lines laid along their routes.
  /// If given, friction is mobilised by the displacement from this state, as in a step of `duration` without inertia.
  const SystemState* laid = nullptr;
  double duration = 0.0;  ///< [s]
};

/// Maximum step of a free body per iteration.
struct BodyStep {
  double move = 0.3;     ///< [m]
  double turn = 0.0087;  ///< [rad]
};

class Equilibrium {
 public:
  static constexpr int kAllLines = -1;

  /// `assembly`: of a system whose surroundings are set. `only`: index of the line that is solved alone, in still
  /// water, with its ends fixed. `assembly` and the state of the rule must outlive this object.
  Equilibrium(Assembly& assembly, const EquilibriumRule& rule, int only = kAllLines);

  /// Makes the line with the system's far force, laid in `plane`, slide at its end `attachment` as `end` prescribes.
  /// Both must outlive this object.
  void slide(FarEnd& end, std::size_t attachment, const LayPlane& plane);

  Assembly& assembly() { return *assembly_; }
  const Assembly& assembly() const { return *assembly_; }
  Increments increments() const { return assembly_->increments(); }
  /// Returns the line that slides or is solved alone; otherwise the first.
  const LineAssembly& line() const { return assembly_->line(line_); }
  double& far_force(SystemState& state) const { return state.lines[line_].far_force; }

  /// Computes internal minus external forces; `with_tangent`: also the tangent blocks. Held directions remain: see
  /// hold().
  void evaluate(SystemState& state, bool with_tangent);
  /// Same with the far end held as for the previous state.
  void evaluate_forces(SystemState& state, bool with_tangent);
  void hold(bool with_tangent);
  /// Returns the largest unbalanced force over the force scale; moments count over the length of the shortest element
  /// at the node.
  double relative_residual();
  TargetEquation target_equation(const EquilibriumTarget& target, const SystemState& state) const;
  /// Puts the far force and the target into the border.
  void put_target(const EquilibriumTarget& target, const SystemState& state);

  /// Solves for the increments from the last evaluated state, with `damping` added to the diagonal per length [N/m2].
  /// The far force is constant if `free_far_force` is false. Returns false if the equations are singular.
  bool solve(double damping, bool free_far_force, Increments& dq);
  /// Node without a pivot in the last solve of all lines, -1 if there was none; the target's node if its equation is
  /// singular.
  int singular_node() const;
  /// Share of a step within the limits of translation and rotation of nodes and bodies.
  double step_limit(const Increments& dq, const BodyStep& of_bodies) const;
  double body_limit(const Increments& dq, const BodyStep& max_step) const;
  /// Share of a step up to which no roller is penetrated by more than `depth` beyond its present penetration [m].
  double share_before_entering(const Increments& dq, double depth) const;
  /// Sets `to` = `from` + share * dq; the far force is unchanged.
  void advance(SystemState& to, const SystemState& from, const Increments& dq, double share) const;
  /// Work of the unbalanced forces on a displacement, with the sign of the residual and the far force increased by
  /// `more_far_force` [J].
  double work(const Increments& dq, double more_far_force = 0.0) const;

 private:
  /// True if bodies and surroundings are updated for each state; otherwise all ends are fixed.
  bool moves_ends() const { return only_ == kAllLines && (rule_.laid != nullptr || assembly_->free_bodies() > 0); }
  void set_rates(SystemState& state) const;
  void evaluate_line(SystemState& state, bool with_tangent);

  Assembly* assembly_;
  EquilibriumRule rule_;
  int only_;
  std::size_t first_, last_;  ///< Range of the lines that are solved; the last is excluded.
  std::size_t line_;          ///< See line().
  FarEnd* far_end_ = nullptr;
  std::size_t far_attachment_ = 0;
  const LayPlane* plane_ = nullptr;
  int target_node_ = -1;
  std::vector<Vec3> directions_;  ///< Directions of the guides at the last increments.
};

}  // namespace overbend
