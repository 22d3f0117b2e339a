/// The equations of statics: a line on its supports, at rest.
///
/// Unknowns: position and tangent of every node, and the horizontal force H that holds the far end. The far end may
/// slide along the bed under H; the top node stands at the tensioner, held in the guide's direction. The extra equation
/// says what is wanted: the effective tension at the tensioner, or the place of the anchor. Because the strain at a
/// node is |t| - 1, the first is local:
///     EA (|t_top| - 1) + pressure part = T
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "numerics/bordered_system.h"
#include "statics/lay_shape.h"
#include "system/line_assembly.h"

namespace overbend {

/// `to` = `from` + share * dq, digits beyond a double kept in `low` (two-sum, Knuth 1969).
void advance(LineState& to, const LineState& from, const std::vector<double>& dq, double share);

/// What the extra equation asks for.
struct LineTargetValue {
  enum class Kind { top_tension, anchor_distance } kind = Kind::top_tension;
  double value = 0.0;  ///< [N], or horizontal distance from tensioner to anchor [m].
};

class StaticSystem {
 public:
  StaticSystem(const Model& model, const VesselPose& pose, LineMesh mesh);

  const Model& model() const { return *model_; }
  const VesselPose& pose() const { return pose_; }  ///< Of the vessel.
  const Line& line() const { return parts_->line; }
  const LineMesh& mesh() const { return line().mesh; }
  const LineElements& elements() const { return line().elements; }
  const LayPlane& plane() const { return plane_; }
  const LineEnvironment& environment() const { return assembly_.environment(); }
  const StaticYielding& yielding_points() const { return assembly_.yielding_at_rest(); }
  const RollerContacts& rollers() const { return assembly_.contacts(); }
  const std::vector<RollerContact>& contacts() const { return assembly_.contacts().contacts(); }
  const std::vector<double>& residual() const { return assembly_.residual(); }
  const std::vector<double>& cuts() const { return assembly_.cuts(); }
  BlockTridiagonal& tangent() { return assembly_.tangent(); }
  Vec3 far_direction() const { return far_direction_; }
  /// Direction of the pipe in its guide at the tensioner, towards it; none where it may turn.
  const std::optional<Vec3>& held_direction() const { return guide_; }
  double total_weight() const { return line().force_scale; }  ///< In air [N].

  /// Roller stiffness is limited to this [N/m]: continuation from soft to hard.
  void limit_roller_stiffness(double limit);
  /// Stiffness of the bed, normal and in friction, is limited to this [N/m2]: continuation from soft to hard.
  void limit_bed_stiffness(double limit);
  /// Whether side rollers act.
  void use_side_rollers(bool use);
  /// Factor on the plastic moments: 0 is linear steel, 1 is what the model says.
  void let_yield(double factor);
  /// Factor on the current's speed.
  void scale_current(double scale);
  /// Whether steel that may yield keeps what bent it upstream: the tangent does not know that.
  bool remembers() const { return assembly_.remembers(); }
  /// Memories of all Gauss points at `state`, for what comes after statics; empty where nothing yields.
  std::vector<BendingMemory> bending_memory(const LineState& state);

  /// Internal minus external forces; with `with_tangent` also the blocks. Held directions are left in: see hold().
  void evaluate(const LineState& state, bool with_tangent);

  /// Largest unbalanced force over the total weight; moments count over the length of the shortest element beside the
  /// node.
  double relative_residual() const { return assembly_.unbalance().force / total_weight(); }
  /// What the extra equation lacks: value minus target, and its gradient, which acts on one node only.
  double target_error(const LineState& state, const LineTargetValue& target) const;

  /// Removes the held directions from the residual and, where asked, from the blocks.
  void hold(bool blocks);
  /// Solves K dq + (border) = -R together with the extra equation, or with dH = 0 where `free_far_force` is false.
  /// `damping` is added to the diagonal per length. False if K is singular.
  bool solve_step(const LineState& state, const LineTargetValue& target, double damping, bool free_far_force,
                  std::vector<double>& dq, double& dH);
  int singular_node() const { return solve_report_.singular_node; }
  int negative_blocks() const { return solve_report_.negative_blocks; }
  /// Share of the step `dq` up to which no roller is entered deeper than `depth` beyond where it is now [m].
  double share_before_entering(const std::vector<double>& dq, double depth) const;
  /// Work of the unbalanced forces on a displacement, sign of the residual [J].
  double work(const std::vector<double>& dq) const;
  /// Forces on the held ends: what tensioner and anchor exert on the line [N]. Needs evaluate() without hold().
  Vec3 end_reaction(int node) const;

 private:
  void hold_ends(const VesselPose& pose);
  int put_border(const LineState& state, const LineTargetValue& target);

  /// What the assembly points to: it stays where it is when the system moves.
  struct Parts {
    Line line;
    std::vector<Body> bodies;
    std::vector<RigidMotion> motions;  ///< Of the bodies, at rest.
  };
  static std::unique_ptr<const Parts> parts_of(const Model& model, const VesselPose& pose, LineMesh mesh,
                                               const LayPlane& plane);

  const Model* model_;
  VesselPose pose_;
  LayPlane plane_;
  std::unique_ptr<const Parts> parts_;
  std::unique_ptr<BorderedSystem> solver_;  ///< Its one shared unknown is the far force.
  LineAssembly assembly_;
  Easing easing_;
  Vec3 far_direction_ = Vec3::UnitX();
  std::optional<Vec3> guide_;
  HeldDirections held_far_, held_top_;
  BorderedReport solve_report_;
};

}  // namespace overbend
