/// A lay in statics: its pipe with the rollers of its vessel as a system of one line, and the equations of its rest.
///
/// The far end may slide along the bed under the far force; the top node stands at the tensioner, held in the guide's
/// direction. See Equilibrium.
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
  const VesselPose& pose() const { return pose_; }  ///< Of the vessel.
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
  /// What the line is held along at its far end, at a distance along the route; none where it may turn there.
  std::optional<Vec3> held_far_direction(double distance) const { return parts_->far_end.held_direction(distance); }
  /// Direction of the pipe in its guide at the tensioner, towards it; none where it may turn.
  const std::optional<Vec3>& held_direction() const { return guide_; }
  double total_weight() const { return line().force_scale; }  ///< In air [N].

  const Continuation& continuation() const { return pipe().continuation(); }
  void set(const Continuation& continuation) { parts_->assembly.set(continuation); }
  /// Whether steel that may yield keeps what bent it upstream: the tangent does not know that.
  bool remembers() const { return pipe().remembers(); }
  /// What the steel was before this state, in place of a loading history.
  void begin_with(std::vector<BendingMemory> before) { pipe().begin_with(std::move(before)); }
  /// What rollers exert on the elements, from the contacts of the last evaluation, which was of `state`.
  std::vector<RollerPush> roller_pushes(const LineState& state) const { return pipe().roller_pushes(state); }
  /// Memories of all Gauss points at `state`, for what comes after statics; empty where nothing yields.
  std::vector<BendingMemory> bending_memory(const LineState& state);

  Equilibrium& equilibrium() { return parts_->equilibrium; }

  /// Internal minus external forces; with `with_tangent` also the blocks. Held directions are left in: see hold().
  void evaluate(const LineState& state, bool with_tangent);
  /// Largest unbalanced force over the total weight; moments count over the length of the shortest element beside the
  /// node.
  double relative_residual() { return parts_->equilibrium.relative_residual(); }
  /// Value of a target minus what is asked for.
  double target_error(const LineState& state, const EquilibriumTarget& target) const;
  /// Removes the held directions from the residual and, where asked, from the blocks.
  void hold(bool blocks) { parts_->equilibrium.hold(blocks); }

  /// Factors the tangent of the last evaluation, held, together with the target's equation, for solve(). The blocks are
  /// overwritten. False if it is singular.
  bool factor(const LineState& state, const EquilibriumTarget& target);
  /// Solves K x - far_direction y = x, gradient of the target . x = y with these factors, in place: `x` six per node,
  /// `y` on its way in the right-hand side of the target's equation, on its way out the change of the far force [N].
  /// Where the pipe is laid steadily, its line goes along so that the miss of its landing changes by `miss` [m].
  void solve(std::vector<double>& x, double& y, double miss = 0.0);
  /// Whether the pipe is laid steadily: then its far end may stand anywhere across the route, and its line goes through
  /// there.
  bool lays_steadily() const { return parts_->far_end.lays_steadily(); }
  /// By how far the pipe first touches the bed to port of the line on which it lies [m]; 0 in steady laying. From the
  /// line of the last evaluation; nothing where it does not touch.
  std::optional<double> landing_miss(const LineState& state) const;
  /// How the state follows its line to port, per metre, after factor(); null where it is not laid steadily.
  struct LineChange {
    std::vector<double> q;
    double far_force = 0.0;  ///< [N/m]
    double miss = 0.0;       ///< [-]
  };
  const LineChange* line_change() const { return line_change_ ? &*line_change_ : nullptr; }
  int singular_node() const { return parts_->equilibrium.singular_node(); }
  /// Forces on the held ends: what tensioner and anchor exert on the line [N]. Needs evaluate() without hold().
  Vec3 end_reaction(int node) const;

 private:
  const LineAssembly& pipe() const { return parts_->pipe(); }
  LineAssembly& pipe() { return parts_->assembly.line(0); }
  SystemState& whole(const LineState& state);
  void find_line_change(const LineState& state);
  void add_friction_by_line(const LineState& state, std::vector<double>& forces) const;

  /// What points to each other: it stays where it is when the system moves.
  struct Parts {
    Parts(const Model& model, const VesselPose& pose, const std::optional<Vec3>& guide, LineMesh mesh);
    const LineAssembly& pipe() const { return assembly.line(0); }

    LayPlane plane;
    System system;
    Assembly assembly;
    FarEnd far_end;
    Equilibrium equilibrium;
    SystemState whole;  ///< With the pipe that was evaluated last.
  };

  const Model* model_;
  VesselPose pose_;
  std::optional<Vec3> guide_;
  std::unique_ptr<Parts> parts_;
  std::vector<double> landing_gradient_;  ///< Of the miss, by the unknowns of the element that lands.
  int landing_element_ = 0;
  std::optional<LineChange> line_change_;
};

/// Point of the centreline closest to a roller: the contact's, or for a roller out of reach that of the whole line.
ClosestPoint closest_to_roller(const StaticSystem& system, const LineState& state, int roller);

}  // namespace overbend
