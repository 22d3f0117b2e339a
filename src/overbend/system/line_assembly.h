/// Residual and tangent of one line with the rollers it meets: one assembly for statics and dynamics.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "system/held_directions.h"
#include "system/roller_contacts.h"
#include "system/state.h"

namespace overbend {

/// Of the largest unbalanced force.
struct Unbalance {
  double force = 0.0;  ///< [N]; moments count over the length of the shortest element beside the node.
  int node = 0;
};

class LineAssembly {
 public:
  /// `line`, `bodies` and the blocks of `tangent` must outlive this.
  LineAssembly(const Line& line, const std::vector<Body>& bodies, BlockTridiagonal& tangent);

  const Line& line() const { return *line_; }
  const RollerContacts& contacts() const { return contacts_; }
  RollerContacts& contacts() { return contacts_; }
  const LineEnvironment& environment() const { return environment_; }
  const StaticYielding& yielding_at_rest() const { return resting_; }
  /// With the last element as long as it is now, or softened.
  const LineElements& elements() const { return softened_ ? *softened_ : paid_ ? *paid_ : line_->elements; }
  /// Unstressed length of the last element, where a winch gives it [m]; 0: that of the mesh.
  void set_last_element(double length);
  /// How the energy of the line grows with that length while its unknowns stand [N]: minus the tension, but for what
  /// the new length brings with it.
  double energy_by_length(const LineShape& shape, const LineMotion& motion) const;
  /// Of the elements, at the state evaluated last: often made with its forces.
  LineEnergy energy(const LineState& state, const std::vector<double>& water) const;

  /// Six per node: internal minus external forces, inertia included.
  const std::vector<double>& residual() const { return residual_; }
  std::vector<double>& residual() { return residual_; }
  /// What the line above a cut at each node exerts on what is below it, as LineTarget::cuts, rollers and yielding
  /// included.
  const std::vector<double>& cuts() const { return cuts_; }
  BlockTridiagonal& tangent() { return *tangent_; }
  const BlockTridiagonal& tangent() const { return *tangent_; }

  const Continuation& continuation() const { return continuation_; }
  void set(const Continuation& continuation);
  /// Brings the first ends of wires to where their bodies are.
  void lead_wires(const std::vector<RigidMotion>& bodies);
  /// Of the wires of the line, at the state evaluated last.
  const std::vector<WirePull>& wire_pulls() const { return wire_pulls_; }
  /// Adds what clumps, buoys and wires store and take at the state evaluated last; powers of wires' ends to `power`.
  void add_attached_energy(const LineState& state, const std::vector<double>& water, LineEnergy& sum,
                           double& power) const;
  /// The pipe has been laid beside the route of the line, everywhere `to_port` metres away.
  void lay_beside(double to_port);
  /// Whether steel that may yield keeps what bent it upstream: the tangent at rest does not know that.
  bool remembers() const { return yielding_.any && continuation_.yielding > 0.0 && before_.empty(); }
  /// What the Gauss points were before, in place of a loading history; empty for none.
  void begin_with(std::vector<BendingMemory> before) { before_ = std::move(before); }

  /// At rest: damping and mass have no weight. The bodies are where contacts().place() put them last; elements that
  /// rollers may meet are looked for anew. `keep_memory` leaves the memories of the steel in yielding_at_rest().
  void evaluate_at_rest(const std::vector<RigidMotion>& bodies, const LineState& state, LayHistory history,
                        bool with_tangent, bool keep_memory = false);

  /// Of the contacts evaluated last, by falling arc length.
  std::vector<RollerPush> roller_pushes(const LineState& state) const;

  /// Another step begins, or the same one again.
  void begin_step() { begins_ = true; }
  /// In motion, `water` as Surroundings::water of the line. The memories of `state` receive what those of `before`, the
  /// same throughout a step, have become after it; of the steel, finish_step() does so where nothing slides.
  void evaluate(LineState& state, const LineState& before, const Weights& weights, const std::vector<double>& water,
                bool with_tangent, ContactMode contacts);

  /// Brings all memories up to the state that was evaluated last, the end of a step.
  void finish_step(LineState& state, const LineState& before);
  /// Energy that yielding stores beyond that of elastic bending, at the state evaluated last [J].
  double stored_by_yielding() const { return yielding_.any ? moving_yielding_.stored() : 0.0; }

  /// After evaluate() without a tangent: puts the tangent of the contacts as they are now beside that of the line as it
  /// was at the last full one. False where contacts reach beyond what was kept, and a full tangent is needed.
  bool renew_contact_tangents(const LineState& state, const Weights& weights);
  /// The first node whose blocks renew_contact_tangents() puts in afresh.
  int kept_from() const { return kept_from_; }

  /// Removes the held directions of a node from the residual and, where asked, from the blocks.
  void hold(int node, const HeldDirections& held, bool blocks);
  Unbalance unbalance() const;
  /// Of the first or the last end.
  int end_node(LineEnd end) const { return end == LineEnd::first ? 0 : line_->mesh.nodes() - 1; }
  /// Force on it by what holds it, with its moment, before hold().
  const std::array<double, 6>& end_force(LineEnd end) const { return kept_[end == LineEnd::first ? 0 : 1].force; }
  /// The same of a node that is an end, or whose force is kept.
  const std::array<double, 6>& held_force(int node) const;
  /// From here on the force on a node between the ends is kept as theirs is.
  void keep_force(int node) { kept_.push_back({node}); }

  LineMotion motion_of(const LineState& state, const LineState& before, const Weights& weights,
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
  LineEnvironment environment_;               ///< As the continuation has it.
  mutable std::optional<LineElements> paid_;  ///< Where a winch gives the last element its length.
  std::optional<LineElements> softened_;      ///< Where a continuation limits the axial stiffness.
  YieldingElements yielding_;                 ///< With its levels.
  std::vector<LinePoint> points_;             ///< As the continuation has them.
  std::vector<LineWire> wires_;               ///< Likewise.
  std::vector<WireEnd> wire_ends_;
  std::vector<WirePull> wire_pulls_;
  Continuation continuation_;
  RollerContacts contacts_;
  StaticYielding resting_;
  std::vector<BendingMemory> before_;
  MovingYielding moving_yielding_;
  bool begins_ = true;  ///< A step is, whose start has not been looked at.
  std::vector<double> residual_, cuts_;
  std::vector<double> by_moments_;    ///< Squared moments over the shortest element at a node become forces [1/m2].
  std::vector<HeldForce> kept_;       ///< Of the first end, of the last, of nodes between them.
  std::optional<LineEnergy> energy_;  ///< Of the last evaluation, where it was made there.
  BlockTridiagonal* tangent_;
  BlockTridiagonal without_contacts_;  ///< From node `kept_from_` on, in motion.
  int kept_from_ = 0;
};

}  // namespace overbend
