/// The equations of a line on its supports: one assembly of residual and tangent.
///
/// Unknowns: position and tangent of every node, and the horizontal force H that holds the far end. The far end may
/// slide along the bed under H; the top node stands at the tensioner, held in the guide's direction. The extra equation
/// says what is wanted: the effective tension at the tensioner, or the place of the anchor. Because the strain at a
/// node is |t| - 1, the first is local:
///     EA (|t_top| - 1) + pressure part = T
#pragma once

#include <vector>

#include "mechanics/contact_cells.h"
#include "mechanics/line_elements.h"
#include "mechanics/roller_contact.h"
#include "numerics/block_tridiagonal.h"
#include "statics/lay_shape.h"
#include "system/held_directions.h"
#include "system/line_mesh.h"
#include "system/yielding.h"

namespace overbend {

/// Unknowns of a line.
struct LineState {
  std::vector<double> q;    ///< Six per node: r [m], t [-]; W.
  std::vector<double> low;  ///< What rounding cut off `q`; empty means zero.
  double far_force = 0.0;   ///< H, away from the barge, along the bed [N].

  LineShape shape() const { return {q.data(), low.empty() ? nullptr : low.data()}; }
};

/// `to` = `from` + share * dq, digits beyond a double kept in `low` (two-sum, Knuth 1969).
void advance(LineState& to, const LineState& from, const std::vector<double>& dq, double share);

/// What the extra equation asks for.
struct LineTargetValue {
  enum class Kind { top_tension, anchor_distance } kind = Kind::top_tension;
  double value = 0.0;  ///< [N], or horizontal distance from tensioner to anchor [m].
};

/// One roller and where the pipe passes it.
struct RollerState {
  ClosestPoint at;
  double penetration = 0.0;       ///< Positive in contact [m].
  Vec3 direction = Vec3::Zero();  ///< In which the roller pushes the pipe.
  double force = 0.0;             ///< Normal force [N].
};

class LineSystem {
 public:
  LineSystem(const Model& model, const VesselPose& pose, LineMesh mesh);

  const Model& model() const { return *model_; }
  const LineMesh& mesh() const { return mesh_; }
  const LayPlane& plane() const { return plane_; }
  const std::vector<PlacedRoller>& rollers() const { return rollers_; }
  const std::vector<RollerState>& roller_states() const { return roller_states_; }
  const std::vector<double>& residual() const { return residual_; }
  const LineElements& elements() const { return elements_; }
  const LineEnvironment& environment() const { return environment_; }
  const YieldingElements& yielding() const { return yielding_; }
  const StaticYielding& yielding_points() const { return yielding_points_; }
  BlockTridiagonal& tangent() { return tangent_; }
  Vec3 far_direction() const { return far_direction_; }
  double total_weight() const { return total_weight_; }  ///< In air [N].

  /// Roller stiffness is limited to this [N/m]: continuation from soft to hard.
  void limit_roller_stiffness(double limit) { roller_limit_ = limit; }
  /// Stiffness of the bed, normal and in friction, is limited to this [N/m2]: continuation from soft to hard.
  void limit_bed_stiffness(double limit);
  /// Whether side rollers act.
  void use_side_rollers(bool use) { use_side_rollers_ = use; }
  /// Share of the plastic moments that acts: 0 is linear steel, 1 is what the model says.
  void let_yield(double share) { yield_share_ = share; }
  /// Whether steel that may yield keeps what bent it upstream: the tangent does not know that.
  bool remembers() const { return yielding_.any && yield_share_ > 0.0; }
  /// Memories of all Gauss points at `state`, for what comes after statics; empty where nothing yields.
  std::vector<BendingMemory> bending_memory(const LineState& state);
  /// Share of the current's speed that acts.
  void scale_current(double scale) { environment_.current_scale = scale; }

  /// Internal minus external forces; with `with_tangent` also the blocks. Held directions are left in: see hold().
  void evaluate(const LineState& state, bool with_tangent);

  /// Largest unbalanced force over the total weight; moments count over the length of the shortest element beside the
  /// node.
  double relative_residual() const;
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
  void place_rollers(const VesselPose& pose);
  void find_contacts(const LineState& state);
  void add_contacts(const LineState& state, bool with_tangent);
  void hold_ends();
  void add_yielding(const LineState& state, bool with_tangent, bool keep_memory);

  const Model* model_;
  LineMesh mesh_;
  LayPlane plane_;
  VesselPose pose_;
  LineElements elements_;
  LineEnvironment environment_;
  YieldingElements yielding_;
  StaticYielding yielding_points_;
  double yield_share_ = 1.0;
  ContactCells cells_;
  std::vector<PlacedRoller> rollers_;
  std::vector<int> roller_box_;
  double roller_limit_ = 1e300;
  bool use_side_rollers_ = true;
  Vec3 far_direction_ = Vec3::UnitX();
  HeldDirections held_far_, held_top_;
  double total_weight_ = 0.0;

  std::vector<double> residual_;
  BlockTridiagonal tangent_;
  BlockSolveReport solve_report_;
  std::vector<ElementBounds> bounds_;
  std::vector<ElementRange> ranges_;
  std::vector<RollerState> roller_states_;
};

/// Normal penalty of `default_stiffness: penalty`: EI / h^3, h the length of the elements over the supports
/// but not less than the diameter: the order of an element's own stiffness across the pipe [N/m].
double penalty_stiffness(const Section& pipe, double element_length);

}  // namespace overbend
