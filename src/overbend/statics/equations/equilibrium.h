/// The equations of rest of a system, or of one of its lines by itself.
///
/// Unknowns: position and tangent of every node, the poses of free bodies, and the force that holds a far end along
/// the bed, which a target closes. Positions keep digits beyond a double (LineState::low).
#pragma once

#include "statics/equations/equilibrium_target.h"
#include "statics/equations/far_end.h"
#include "system/assembly.h"

namespace overbend {

/// `to` = `from` + share * dq, digits beyond a double kept in `low` (two-sum, Knuth 1969).
void advance(LineState& to, const LineState& from, const std::vector<double>& dq, double share);

/// How friction came to act.
struct RestRule {
  LayHistory history = LayHistory::monotonic;  ///< Of the steel, where lines were laid along their routes.
  /// Where given: friction is mobilised by what moved since this state, as in a step of `duration` without inertia.
  const SystemState* laid = nullptr;
  double duration = 0.0;  ///< [s]
};

/// Largest steps of a free body in one iteration.
struct BodyStep {
  double move = 0.3;     ///< [m]
  double turn = 0.0087;  ///< [rad]
};

class Equilibrium {
 public:
  static constexpr int kAllLines = -1;

  /// Of a system whose surroundings are set. `only`: of this line alone, in calm water, its ends where they are.
  /// `assembly` and the state of the rule must outlive this.
  Equilibrium(Assembly& assembly, const RestRule& rule, int only = kAllLines);

  /// The line of the system's far force, laid in `plane`, slides there as `end` says, which is at `attachment`. Both
  /// must outlive this.
  void slide(FarEnd& end, std::size_t attachment, const LayPlane& plane);

  Assembly& assembly() { return *assembly_; }
  const Assembly& assembly() const { return *assembly_; }
  Increments increments() const { return assembly_->increments(); }
  /// The line that slides, or that is solved alone; else the first.
  const LineAssembly& line() const { return assembly_->line(line_); }
  double& far_force(SystemState& state) const { return state.lines[line_].far_force; }

  /// Internal minus external forces; with `with_tangent` also the blocks. Held directions are left in: see hold().
  void evaluate(SystemState& state, bool with_tangent);
  /// The same with the far end held as for the state before.
  void evaluate_forces(SystemState& state, bool with_tangent);
  void hold(bool with_tangent);
  /// Largest unbalanced force over the force scale; moments count over the length of the shortest element beside the
  /// node.
  double relative_residual();
  TargetEquation target_equation(const EquilibriumTarget& target, const SystemState& state) const;
  /// Far force and target into the border.
  void put_target(const EquilibriumTarget& target, const SystemState& state);

  /// Solves for the increments from the state evaluated last, `damping` added to the diagonal per length [N/m2]. The
  /// far force stays where `free_far_force` is false. False where the equations are singular.
  bool solve(double damping, bool free_far_force, Increments& dq);
  /// Node without a pivot in the last solve of the whole, -1 where there was none; the target's where it fails there.
  int singular_node() const;
  /// Share of a step within the limits of what nodes and bodies may move and turn.
  double step_limit(const Increments& dq, const BodyStep& of_bodies) const;
  double body_limit(const Increments& dq, const BodyStep& most) const;
  /// Share of a step up to which no roller is entered deeper than `depth` beyond where it is now [m].
  double share_before_entering(const Increments& dq, double depth) const;
  /// `to` = `from` + share * dq; the far force stays.
  void advance(SystemState& to, const SystemState& from, const Increments& dq, double share) const;
  /// Work of the unbalanced forces on a displacement, sign of the residual; with the far force larger by this [J].
  double work(const Increments& dq, double more_far_force = 0.0) const;

 private:
  /// Whether bodies and surroundings are brought to each state; else all ends stay where they are.
  bool moves_ends() const { return only_ == kAllLines && (rule_.laid != nullptr || assembly_->free_bodies() > 0); }
  void set_rates(SystemState& state) const;
  void evaluate_line(SystemState& state, bool with_tangent);

  Assembly* assembly_;
  RestRule rule_;
  int only_;
  std::size_t first_, last_;  ///< Lines that are solved for, the last excluded.
  std::size_t line_;          ///< See line().
  FarEnd* far_end_ = nullptr;
  std::size_t far_attachment_ = 0;
  const LayPlane* plane_ = nullptr;
  int target_node_ = -1;
  std::vector<Vec3> directions_;  ///< Of guides where the last increments were found.
};

}  // namespace overbend
