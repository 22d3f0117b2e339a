/// A line in motion: constant data, state, and the equations at one instant.
#pragma once

#include <array>
#include <functional>
#include <vector>

#include "mechanics/line_elements.h"
#include "mechanics/tensioner.h"
#include "numerics/generalized_alpha.h"
#include "system/held_directions.h"
#include "system/line_mesh.h"
#include "system/moving_contacts.h"
#include "system/yielding.h"

namespace overbend {

/// Prescribed motion of an end: place and direction of the guide with their rates, W. The direction is that in which a
/// machine moves the pipe, whether the guide holds the pipe's direction or lets it turn.
struct EndMotion {
  Vec3 place = Vec3::Zero(), velocity = Vec3::Zero(), acceleration = Vec3::Zero();
  Vec3 direction = Vec3::UnitX(), direction_rate = Vec3::Zero(), direction_acceleration = Vec3::Zero();
};

/// What holds an end of the line.
struct LineEnd {
  bool hold_place = false;
  bool hold_direction = false;  ///< The tangent keeps the guide's direction; its length stays free.
};

/// The surroundings that move: everything that depends on time alone.
struct Surroundings {
  RigidMotion vessel;
  EndMotion anchor, top;
  /// Waves at the nodes, kWaterValues each; empty in calm water.
  std::vector<double> water;
};

/// Sets the surroundings for a time. Called once per step, must not allocate after the first call.
using SurroundingsAt = std::function<void(double time, Surroundings& now)>;

/// Constant data of a run.
struct DynamicLine {
  LineMesh mesh;
  LineElements elements;
  LineEnvironment environment;
  YieldingElements yielding;
  LineEnd anchor, top;
  TensionerLaw tensioner;  ///< Moves the top along its guide, where it is held; the default is a locked brake.
  double build_up = 0.0;   ///< Before t = 0, over which the tensioner is brought in [s].
  std::vector<MovingRoller> rollers;
  ContactCells cells;
  Vec3 shoe_V = Vec3::Zero();  ///< Origin of the ramp's frame, for the cells [m].
  SurroundingsAt surroundings;
  double force_scale = 1.0;  ///< What unbalanced forces are measured against: the line's weight in air [N].
};

/// Length of the tangent in a guide, the one unknown left there.
using GuideValues = MotionValues;

/// What the equations of motion change.
struct DynamicState {
  double time = 0.0;              ///< [s]
  std::vector<double> q, v, acc;  ///< Six per node: r, t and their rates; W.
  std::vector<double> alg;        ///< Algorithmic accelerations, see GeneralizedAlpha.
  GuideValues anchor_guide{}, top_guide{};
  TensionerMachine machine;
  MotionValues travel{};    ///< Of the tensioner, what was paid out [m].
  double last_step = 0.0;   ///< That led here; 0 at the start [s].
  AlignedDoubles bed_slip;  ///< See LineMotion.
  std::vector<ContactMemory> contacts;
  std::vector<BendingMemory> bending;  ///< Per Gauss point; empty where no steel yields.
  double bending_heat = 0.0;           ///< Made by yielding so far [J].
};

/// Sums of energies and powers at one instant; see EnergyBalance.
struct InstantEnergy {
  LineEnergy line;
  double contact = 0.0;                            ///< In the springs of the rollers [J].
  double roller_power = 0.0;                       ///< Of the moving rollers on the pipe [W].
  double contact_loss = 0.0, friction_loss = 0.0;  ///< [W]
  double top_power = 0.0, anchor_power = 0.0;      ///< [W]
  double bending_heat = 0.0;                       ///< Made by yielding so far [J].
};

class DynamicSystem {
 public:
  explicit DynamicSystem(const DynamicLine& line);

  const DynamicLine& line() const { return *line_; }
  const Surroundings& surroundings() const { return surroundings_; }
  const std::vector<MovingContact>& contacts() const { return contacts_.contacts(); }
  std::uint64_t contact_signature() const { return contacts_.signature(); }
  bool contacts_settled() const { return contacts_.settled(); }
  const std::vector<double>& residual() const { return residual_; }
  /// What the line above a cut at each node exerts on what is below it, as LineTarget::cuts, rollers and yielding
  /// included.
  const std::vector<double>& cuts() const { return cuts_; }
  BlockTridiagonal& tangent() { return tangent_; }

  /// Brings the surroundings to a time, and the rollers to the line as it is in `near`.
  void set_time(double time, const DynamicState& near);
  /// What decides the speed of the tensioner at the instants to come.
  void set_drive(TensionerDrive drive);
  /// Puts prescribed places, directions and their rates into the ends of a state.
  void impose_ends(DynamicState& state) const;

  /// Inertia plus internal minus external forces at `state`; its memories receive what those of `before` have become
  /// after the step.
  void evaluate(DynamicState& state, const DynamicState& before, const StepShares& shares, bool with_tangent,
                ContactMode contacts = ContactMode::free);
  /// Brings the factors up to the contacts of the last evaluation, which had no tangent: the line's part is that of the
  /// last factors, and those before the first roller stand. False where a full tangent is needed.
  bool renew_contacts(const DynamicState& state, const StepShares& shares);
  /// Before a correction that the last evaluation led to; see MovingContacts.
  void end_iteration(const DynamicState& state) { contacts_.end_iteration(state.contacts); }
  /// Removes held directions from residual and, where asked, blocks.
  void hold(bool with_tangent);
  /// Largest unbalanced force over the force scale; moments over the length of the shortest element beside the node.
  double relative_residual() const;
  int worst_node() const { return worst_node_; }

  /// Factors the blocks and solves for the increments of the unknowns; false where they are singular.
  bool solve_factored(std::vector<double>& dq);
  /// The same with the factors of the last `solve_factored`.
  void solve_again(std::vector<double>& dq);

  /// Of the state evaluated last.
  InstantEnergy energy(const DynamicState& state) const;
  /// Force on the line by what holds its top, at the state evaluated last [N].
  Vec3 top_force() const;
  /// What the tensioner measures: its force along the pipe, which is the effective tension there [N].
  double machine_tension() const { return top_force().dot(machine_axis_); }

  /// True accelerations from the balance of forces at rest or in motion; false where the mass is singular.
  bool find_accelerations(DynamicState& state);

 private:
  bool governed() const { return line_->top.hold_place && drive_ == TensionerDrive::governor; }
  void add_governor(const DynamicState& state);
  void add_governor_tangent(const DynamicState& state, const StepShares& shares);
  void add_contact_tangents(const DynamicState& state, const StepShares& shares);
  LineMotion motion_of(const DynamicState& state, const DynamicState& before, const StepShares& shares,
                       double* next_slip) const;
  HeldDirections held_by(const LineEnd& end, const EndMotion& motion, bool free_along) const;

  const DynamicLine* line_;
  Surroundings surroundings_;
  MovingContacts contacts_;
  std::vector<double> residual_, cuts_;
  std::vector<Vec3> plastic_moment_;  ///< What yielding takes off the elastic moment, per Gauss point.
  std::array<double, 6> anchor_residual_{}, top_residual_{};  ///< Before hold().
  BlockTridiagonal tangent_;
  BlockTridiagonal line_tangent_;  ///< Without contacts, from node `kept_from_` on.
  int kept_from_ = 0;
  HeldDirections held_anchor_, held_top_;
  TensionerDrive drive_ = TensionerDrive::brake;
  Vec3 machine_axis_ = Vec3::UnitX();  ///< Of the pipe at its top, at the state evaluated last.
  mutable int worst_node_ = 0;
};

/// Share of its response velocity that the tensioner may use: it is brought in with the sea.
double tensioner_authority(const DynamicLine& line, double time);

/// A state at rest in the given shape, memories empty, at `time`.
DynamicState state_at_rest(const DynamicLine& line, const std::vector<double>& q, double time);

}  // namespace overbend
