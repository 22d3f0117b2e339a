/// The equations of a system in motion at one instant: what its lines, their ends and the machine at one of them add up
/// to.
#pragma once

#include <cstdint>
#include <vector>

#include "numerics/bordered_system.h"
#include "system/line_assembly.h"
#include "system/system.h"

namespace overbend {

/// Sums of energies and powers at one instant; see EnergyBalance.
struct InstantEnergy {
  LineEnergy line;
  double contact = 0.0;                            ///< In the springs of the rollers [J].
  double roller_power = 0.0;                       ///< Of the moving rollers on the pipe [W].
  double contact_loss = 0.0, friction_loss = 0.0;  ///< [W]
  double top_power = 0.0, anchor_power = 0.0;      ///< Of what holds last and first ends [W].
  double bending_heat = 0.0;                       ///< Made by yielding so far [J].
};

/// Unknowns of every line, six per node.
using Increments = std::vector<std::vector<double>>;

class Assembly {
 public:
  explicit Assembly(const System& system);
  Assembly(const Assembly&) = delete;
  Assembly& operator=(const Assembly&) = delete;

  const System& system() const { return *system_; }
  const Surroundings& surroundings() const { return surroundings_; }
  const LineAssembly& line(std::size_t index) const { return lines_[index]; }
  LineAssembly& line(std::size_t index) { return lines_[index]; }
  Increments increments() const;  ///< Of the right sizes.

  std::uint64_t contact_signature() const;
  bool contacts_settled() const;

  /// Brings the surroundings to a time, and the rollers to the lines as they are in `near`.
  void set_time(double time, const SystemState& near);
  /// What decides the speed of the tensioner at the instants to come.
  void set_drive(TensionerDrive drive);
  /// Puts prescribed places, directions and their rates into the ends of a state.
  void impose_ends(SystemState& state) const;

  /// Inertia plus internal minus external forces at `state`; its memories receive what those of `before` have become
  /// after the step.
  void evaluate(SystemState& state, const SystemState& before, const Weights& weights, bool with_tangent,
                ContactMode contacts = ContactMode::free);
  /// Brings the factors up to the contacts of the last evaluation, which had no tangent: the lines' part is that of the
  /// last factors, and those before the first roller stand. False where a full tangent is needed.
  bool renew_contacts(const SystemState& state, const Weights& weights);
  /// Before a correction that the last evaluation led to; see RollerContacts.
  void end_iteration(const SystemState& state);
  /// Removes held directions from residual and, where asked, blocks.
  void hold(bool with_tangent);
  /// Largest unbalanced force of a line over its force scale.
  double relative_residual();
  /// Where it was found: line and node.
  std::pair<int, int> worst_place() const { return worst_; }

  /// Factors the blocks and solves for the increments of the unknowns; false where they are singular.
  bool solve_factored(Increments& dq);
  /// The same with the factors of the last `solve_factored`.
  void solve_again(Increments& dq);
  /// Replaces forces on the unknowns by the increments that they make, with the same factors.
  void apply_factors(Increments& dq);

  /// Of the state evaluated last.
  InstantEnergy energy(const SystemState& state) const;
  /// What the tensioner measures: its force along the pipe, which is the effective tension there [N].
  double machine_tension() const;

  /// True accelerations from the balance of forces at rest or in motion; false where the mass is singular.
  bool find_accelerations(SystemState& state);

 private:
  bool governed(std::size_t attachment) const;
  void take_residual(Increments& dq);
  void find_held();
  void add_governor(const SystemState& state);
  void add_governor_tangent(const SystemState& state, const Weights& weights);
  void find_machine_axis(const SystemState& state);

  const System* system_;
  Surroundings surroundings_;
  BorderedSystem solver_;
  std::vector<LineAssembly> lines_;
  std::vector<double*> solution_;     ///< Of the lines, for the solver.
  std::vector<HeldDirections> held_;  ///< By the attachments.
  TensionerDrive drive_ = TensionerDrive::brake;
  Vec3 machine_axis_ = Vec3::UnitX();  ///< Of the pipe at its tensioner, at the state evaluated last.
  std::pair<int, int> worst_{0, 0};
};

/// A system at rest with its lines in the given shapes, memories empty, at `time`.
SystemState state_at_rest(const System& system, const std::vector<std::vector<double>>& q, double time);

}  // namespace overbend
