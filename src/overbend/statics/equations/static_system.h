/// Lay in statics: its pipe with the rollers of its vessel as a system of one line, and its equilibrium equations.
///
/// The far end may slide along the bed under the far force; the top node is fixed at the tensioner and held in the
/// guide's direction. See Equilibrium.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "statics/equations/equilibrium.h"

namespace overbend {

class StaticSystem {
 public:
  StaticSystem(const Model& model, const VesselPose& pose, LineMesh mesh);

  const Model& model() const { return *model_; }
  const VesselPose& pose() const { return pose_; }  ///< Pose of the vessel.
  const Line& line() const { return parts_->system.lines.front(); }
  const LineMesh& mesh() const { return line().mesh; }
  const LineElements& elements() const { return line().elements; }
  const LayPlane& plane() const { return parts_->plane; }
  const LineEnvironment& environment() const { return pipe().environment(); }
  const StaticYielding& yielding_points() const { return pipe().yielding_at_rest(); }
  const RollerContacts& rollers() const { return pipe().contacts(); }
  const std::vector<RollerContact>& contacts() const { return rollers().contacts(); }
  const std::vector<WirePull>& wire_pulls() const { return pipe().wire_pulls(); }
  const std::vector<double>& residual() const { return pipe().residual(); }
  const std::vector<double>& cuts() const { return pipe().cuts(); }
  BlockTridiagonal& tangent() { return pipe().tangent(); }
  Vec3 far_direction() const { return parts_->far_end.direction(); }
  /// Direction in which the line is held at its far end, at a distance along the route; nullopt if it may turn there.
  std::optional<Vec3> held_far_direction(double distance) const { return parts_->far_end.held_direction(distance); }
  /// Direction of the pipe in its guide at the tensioner, towards it; nullopt if it may turn.
  const std::optional<Vec3>& held_direction() const { return guide_; }
  double total_weight() const { return line().force_scale; }  ///< Weight in air [N].

  const Continuation& continuation() const { return pipe().continuation(); }
  void set(const Continuation& continuation) { parts_->assembly.set(continuation); }
  /// True if yielding steel keeps plastic strain from supports upstream, which the tangent does not include.
  bool has_plastic_memory() const { return pipe().has_plastic_memory(); }
  /// Sets the memory of the steel before this state, in place of a loading history.
  void set_bending_history(std::vector<BendingMemory> before) { pipe().set_bending_history(std::move(before)); }
  /// Roller forces on the elements, from the contacts of the last evaluation, which was of `state`.
  std::vector<RollerPush> roller_pushes(const LineState& state) const { return pipe().roller_pushes(state); }
  /// Memories of all Gauss points at `state`, for use after statics; empty if nothing yields.
  std::vector<BendingMemory> bending_memory(const LineState& state);

  Equilibrium& equilibrium() { return parts_->equilibrium; }

  /// Computes internal minus external forces; `with_tangent`: also the tangent blocks. Held directions remain: see
  /// hold().
  void evaluate(const LineState& state, bool with_tangent);
  /// Returns the largest unbalanced force over the total weight; moments count over the length of the shortest element
  /// at the node.
  double relative_residual() { return parts_->equilibrium.relative_residual(); }
  /// Value of a target minus its target value.
  double target_error(const LineState& state, const EquilibriumTarget& target) const;
  /// Removes the held directions from the residual and, if `blocks`, from the tangent blocks.
  void hold(bool blocks) { parts_->equilibrium.hold(blocks); }

  /// Factors the held tangent of the last evaluation together with the target's equation, for solve(). The blocks are
  /// overwritten. Returns false if it is singular.
  bool factor(const LineState& state, const EquilibriumTarget& target);
  /// Solves K x - far_direction y = x, gradient of the target . x = y with these factors, in place. `x`: six per node.
  /// `y`: on entry the right-hand side of the target's equation, on exit the change of the far force [N]. In steady
  /// laying, the line moves so that the miss of its landing changes by `miss` [m].
  void solve(std::vector<double>& x, double& y, double miss = 0.0);
  /// True in steady laying: the far end may be anywhere across the route, and the line passes through it.
  bool lays_steadily() const { return parts_->far_end.lays_steadily(); }
  /// Distance to port of the line on which the pipe lies, at the point where it first touches the bed [m]; 0 in steady
  /// laying. Uses the line of the last evaluation; nullopt if it does not touch.
  std::optional<double> landing_miss(const LineState& state) const;
  /// Derivative of the state with respect to the offset of its line to port, per metre, after factor(); null if not in
  /// steady laying.
  struct LineChange {
    std::vector<double> q;
    double far_force = 0.0;  ///< [N/m]
    double miss = 0.0;       ///< [-]
  };
  const LineChange* line_change() const { return line_change_ ? &*line_change_ : nullptr; }
  int singular_node() const { return parts_->equilibrium.singular_node(); }
  /// Forces of tensioner and anchor on the held ends of the line [N]. Needs evaluate() without hold().
  Vec3 end_reaction(int node) const;

 private:
  const LineAssembly& pipe() const { return parts_->pipe(); }
  LineAssembly& pipe() { return parts_->assembly.line(0); }
  SystemState& complete_state(const LineState& state);
  void find_line_change(const LineState& state);
  void add_friction_by_line(const LineState& state, std::vector<double>& forces) const;

  /// Members that point to each other; their addresses stay constant when the system is moved.
  struct Parts {
    Parts(const Model& model, const VesselPose& pose, const std::optional<Vec3>& guide, LineMesh mesh);
    const LineAssembly& pipe() const { return assembly.line(0); }

    LayPlane plane;
    System system;
    Assembly assembly;
    FarEnd far_end;
    Equilibrium equilibrium;
    SystemState complete_state;  ///< Complete state, with the pipe evaluated last.
  };

  const Model* model_;
  VesselPose pose_;
  std::optional<Vec3> guide_;
  std::unique_ptr<Parts> parts_;
  std::vector<double> landing_gradient_;  ///< Gradient of the miss with respect to the unknowns of the landing element.
  int landing_element_ = 0;
  std::optional<LineChange> line_change_;
};

/// Point of the centreline closest to a roller: the contact's, or that of the whole line for a roller out of reach.
ClosestPoint closest_to_roller(const StaticSystem& system, const LineState& state, int roller);

}  // namespace overbend
