/// Residual and tangent of one line with its roller contacts, for statics and dynamics.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "system/held_directions.h"
#include "system/roller_contacts.h"
#include "system/state.h"

namespace overbend {

/// Maximum unbalanced force.
struct Unbalance {
  double force = 0.0;  ///< [N]; moments count over the length of the shortest element next to the node.
  int node = 0;
};

/// Equations of one line.
class LineAssembly {
 public:
  /// `line`, `bodies` and the blocks of `tangent` must outlive this.
  LineAssembly(const Line& line, const std::vector<Body>& bodies, BlockTridiagonal& tangent);

  const Line& line() const { return *line_; }
  const RollerContacts& contacts() const { return contacts_; }
  RollerContacts& contacts() { return contacts_; }
  const LineEnvironment& environment() const { return environment_; }
  const StaticYielding& yielding_at_rest() const { return resting_; }
  /// Element constants with the present length of the last element, or with limited axial stiffness.
  const LineElements& elements() const { return softened_ ? *softened_ : paid_ ? *paid_ : line_->elements; }
  /// Sets the unstressed length of the last element as given by a winch [m]; 0: that of the mesh.
  void set_last_element(double length);
  /// Returns the derivative of the line's energy by that length at constant unknowns [N]: minus the tension, apart from
  /// the energy of the added length.
  double energy_by_length(const LineShape& shape, const LineMotion& motion) const;
  /// Returns the energy of the elements at the last evaluated state, often computed with its forces.
  LineEnergy energy(const LineState& state, const std::vector<double>& water) const;

  /// Internal minus external forces, inertia included; six per node.
  const std::vector<double>& residual() const { return residual_; }
  std::vector<double>& residual() { return residual_; }
  /// Forces of the line above a cut at each node on the line below it, as LineTarget::cuts, rollers and yielding
  /// included.
  const std::vector<double>& cuts() const { return cuts_; }
  BlockTridiagonal& tangent() { return *tangent_; }
  const BlockTridiagonal& tangent() const { return *tangent_; }

  const Continuation& continuation() const { return continuation_; }
  void set(const Continuation& continuation);
  /// Moves the first ends of wires with their bodies.
  void set_wire_ends(const std::vector<RigidMotion>& bodies);
  /// Pulls of the wires of the line at the last evaluated state.
  const std::vector<WirePull>& wire_pulls() const { return wire_pulls_; }
  /// Adds the energies and powers of clumps, buoys and wires at the last evaluated state; powers of the wire ends to
  /// `power`.
  void add_attached_energy(const LineState& state, const std::vector<double>& water, LineEnergy& sum,
                           double& power) const;
  /// Sets a constant lateral offset of the laid pipe from the line's route, `to_port` [m].
  void set_lateral_offset(double to_port);
  /// True if plastic memory from the bending upstream acts, which the tangent at rest ignores.
  bool has_plastic_memory() const { return yielding_.any && continuation_.yielding > 0.0 && before_.empty(); }
  /// Sets the initial memories of the Gauss points in place of a loading history; empty for none.
  void set_bending_history(std::vector<BendingMemory> before) { before_ = std::move(before); }

  /// Evaluates the line at rest: damping and mass have no weight. The bodies are at their last contacts().place();
  /// elements within reach of rollers are searched again. `keep_memory` keeps the plastic memories in
  /// yielding_at_rest().
  void evaluate_at_rest(const std::vector<RigidMotion>& bodies, const LineState& state, LayHistory history,
                        bool with_tangent, bool keep_memory = false);

  /// Returns the pushes of the last evaluated contacts, by descending arc length.
  std::vector<RollerPush> roller_pushes(const LineState& state) const;

  /// Starts a new step or repeats one.
  void begin_step() { begins_ = true; }
  /// Evaluates the line in motion, with `water` as Surroundings::water of the line. The memories of `state` are updated
  /// from those of `before`, which are constant throughout a step; finish_step() updates the plastic memories that do
  /// not slide.
  void evaluate(LineState& state, const LineState& before, const Weights& weights, const std::vector<double>& water,
                bool with_tangent, ContactMode contacts);

  /// Updates all memories to the last evaluated state, the end of a step.
  void finish_step(LineState& state, const LineState& before);
  /// Returns the energy stored by yielding in excess of elastic bending at the last evaluated state [J].
  double stored_by_yielding() const { return yielding_.any ? moving_yielding_.stored() : 0.0; }

  /// After evaluate() without a tangent: combines the present tangent of the contacts with that of the line from the
  /// last full evaluation. Returns false if contacts reach beyond the stored part and a full tangent is needed.
  bool renew_contact_tangents(const LineState& state, const Weights& weights);
  /// First node whose blocks renew_contact_tangents() renews.
  int kept_from() const { return kept_from_; }

  /// Removes the constrained directions of a node from the residual and, if `blocks`, from the blocks.
  void hold(int node, const HeldDirections& held, bool blocks);
  Unbalance unbalance() const;
  /// Node of the first or last end.
  int end_node(LineEnd end) const { return end == LineEnd::first ? 0 : line_->mesh.nodes() - 1; }
  /// Force and moment that hold an end, before hold().
  const std::array<double, 6>& end_force(LineEnd end) const { return kept_[end == LineEnd::first ? 0 : 1].force; }
  /// The same for an end or an inner node whose force is kept.
  const std::array<double, 6>& held_force(int node) const;
  /// Also keeps the holding force of an inner node from now on.
  void keep_force(int node) { kept_.push_back({node}); }

  LineMotion make_motion(const LineState& state, const LineState& before, const Weights& weights,
                         const std::vector<double>& water, double* next_slip) const;

 private:
  struct HeldForce {
    int node = 0;
    std::array<double, 6> force{};
  };
  LineTarget target(bool with_tangent);
  void add_attached_forces(const LineState& state, const LineMotion& motion, bool with_tangent);
  void keep_forces();

  const Line* line_;
  LineEnvironment environment_;               ///< With the parameters of the continuation.
  mutable std::optional<LineElements> paid_;  ///< With the last element length given by a winch.
  std::optional<LineElements> softened_;      ///< If a continuation limits the axial stiffness.
  YieldingElements yielding_;                 ///< With its levels.
  std::vector<LinePoint> points_;             ///< With the parameters of the continuation.
  std::vector<LineWire> wires_;               ///< Likewise.
  std::vector<WireEnd> wire_ends_;
  std::vector<WirePull> wire_pulls_;
  Continuation continuation_;
  RollerContacts contacts_;
  StaticYielding resting_;
  std::vector<BendingMemory> before_;
  MovingYielding moving_yielding_;
  bool begins_ = true;  ///< True until the start of the present step has been processed.
  std::vector<double> residual_, cuts_;
  /// Factors from squared moments to squared forces, by the shortest element at a node [1/m2].
  std::vector<double> by_moments_;
  std::vector<HeldForce> kept_;       ///< Holding forces of the first end, the last end and inner nodes.
  std::optional<LineEnergy> energy_;  ///< Energy of the last evaluation, if computed there.
  BlockTridiagonal* tangent_;
  BlockTridiagonal without_contacts_;  ///< From node `kept_from_`, in motion.
  int kept_from_ = 0;
};

}  // namespace overbend
