/// The equations of statics: a line on its supports, at rest.
///
/// Unknowns: position and tangent of every node, and the force H that holds the far end along the bed. The far end may
/// slide along the bed under H, on a shaped one turning with it; the top node stands at the tensioner, held in the
/// guide's direction. The extra equation says what is wanted: the effective tension at the tensioner, or the place of
/// the anchor. Because the strain at a node is |t| - 1, the first is local:
///     EA (|t_top| - 1) + pressure part = T
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "numerics/bordered_system.h"
#include "statics/initial_shape/lay_shape.h"
#include "system/line_assembly.h"

namespace overbend {

/// `to` = `from` + share * dq, digits beyond a double kept in `low` (two-sum, Knuth 1969).
void advance(LineState& to, const LineState& from, const std::vector<double>& dq, double share);

/// What the extra equation asks for.
struct LineTargetValue {
  enum class Kind { top_tension, anchor_distance } kind = Kind::top_tension;
  double value = 0.0;  ///< [N], or horizontal distance from tensioner to anchor [m].
};

/// Whether statics look for the line on which this model's pipe was laid: it lies where friction keeps it, and no cable
/// leads its far end to an anchor.
bool lays_steadily(const Model& model);

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
  /// What the line is held along at its far end, at a distance along the route; none where it may turn there.
  std::optional<Vec3> held_far_direction(double distance) const;
  /// Direction of the pipe in its guide at the tensioner, towards it; none where it may turn.
  const std::optional<Vec3>& held_direction() const { return guide_; }
  double total_weight() const { return line().force_scale; }  ///< In air [N].

  /// Roller stiffness is limited to this [N/m]: continuation from soft to hard.
  void limit_roller_stiffness(double limit);
  /// Stiffness of the bed, normal and in friction, is limited to this [N/m2]: continuation from soft to hard.
  void limit_bed_stiffness(double limit);
  /// Factor on the heights of a shaped bed over `level` [m]: continuation from level to the shape.
  void scale_bed_relief(double relief, double level);
  /// Whether side rollers act.
  void use_side_rollers(bool use);
  /// Factor on the plastic moments: 0 is linear steel, 1 is what the model says.
  void let_yield(double factor);
  /// Factor of the rollers' full lateral friction on the pipe, to port.
  void rub_across(double factor);
  /// Factor on the current's speed.
  void scale_current(double scale);
  /// Whether steel that may yield keeps what bent it upstream: the tangent does not know that.
  bool remembers() const { return assembly_.remembers(); }
  /// What the steel was before this state, in place of a loading history.
  void begin_with(std::vector<BendingMemory> before) { assembly_.begin_with(std::move(before)); }
  /// What rollers exert on the elements, from the contacts of the last evaluation, which was of `state`.
  std::vector<RollerPush> roller_pushes(const LineState& state) const { return assembly_.roller_pushes(state); }
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
  /// Factors the tangent of the last evaluation, held, together with the extra equation, for solve(). The blocks are
  /// overwritten. False if it is singular.
  bool factor(const LineState& state, const LineTargetValue& target);
  /// Solves K x - far_direction y = x, gradient of what is wanted . x = y with these factors, in place: `x` six per
  /// node, `y` on its way in the right-hand side of the extra equation, on its way out the change of the far force [N].
  /// Where the pipe is laid steadily, its line goes along so that the miss of its landing changes by `miss` [m].
  void solve(std::vector<double>& x, double& y, double miss = 0.0);
  /// Whether the pipe is laid steadily: then its far end may stand anywhere across the route, and its line goes through
  /// there.
  bool lays_steadily() const { return lays_steadily_; }
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
  void turn_far_end(const LineState& state, bool with_tangent);
  void hold_far_end(double distance);
  void follow_far_end(const LineState& state);
  void find_line_change(const LineState& state);
  void evaluate_on_line(const LineState& state, bool with_tangent);
  void add_friction_by_line(const LineState& state, std::vector<double>& forces) const;
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
  bool lays_steadily_ = false;
  std::vector<double> landing_gradient_;  ///< Of the miss, by the unknowns of the element that lands.
  int landing_element_ = 0;
  std::optional<LineChange> line_change_;
  BorderedReport solve_report_;
};

/// Point of the centreline closest to a roller: the contact's, or for a roller out of reach that of the whole line.
ClosestPoint closest_to_roller(const StaticSystem& system, const LineState& state, int roller);

}  // namespace overbend
