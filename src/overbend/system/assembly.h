/// Equations of a system in motion at one instant: assembly of its lines, their ends and the tensioners.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "numerics/bordered_system.h"
#include "system/body_border.h"
#include "system/line_assembly.h"
#include "system/system.h"

namespace overbend {

/// Sums of energies and powers at one instant; see EnergyBalance.
struct InstantEnergy {
  LineEnergy line;
  double contact = 0.0;                            ///< In the springs of the rollers [J].
  double roller_power = 0.0;                       ///< Power of the moving rollers on the pipe [W].
  double contact_loss = 0.0, friction_loss = 0.0;  ///< [W]
  double top_power = 0.0, anchor_power = 0.0;      ///< Powers of the forces that hold the last and first ends [W].
  double bending_heat = 0.0;                       ///< Dissipated by yielding so far [J].
  BodyEnergy bodies;  ///< Energies of the free bodies; the loads of lines on them are internal.
};

/// Work at the end of an attachment. An end held by a free body has no force.
struct WorkingEnd {
  bool last = false;                       ///< True for the last end of its line.
  std::array<double, 6> force{}, place{};  ///< On the line, and the unknowns of the node.
  double power = 0.0;                      ///< [W]
};

/// Unknowns of every line, six per node; with a border one more entry: six for each free body, then the far forces.
using Increments = std::vector<std::vector<double>>;

/// Linearised equation that closes a far force: gradient . change = -error, at one node of its line.
struct TargetEquation {
  int node = 0;
  bool tangent = false;  ///< Unknowns of the gradient: the tangent, else the position.
  Vec3 gradient = Vec3::Zero();
  double error = 0.0;  ///< Value minus target.
};

inline constexpr int kBodyPlace = -1;  ///< In place of a line number: a free body.

/// Assembly and solution of the equations of a system.
class Assembly {
 public:
  explicit Assembly(const System& system);
  Assembly(const Assembly&) = delete;
  Assembly& operator=(const Assembly&) = delete;

  const System& system() const { return *system_; }
  const Surroundings& surroundings() const { return surroundings_; }
  const LineAssembly& line(std::size_t index) const { return lines_[index]; }
  LineAssembly& line(std::size_t index) { return lines_[index]; }
  Increments increments() const;  ///< Zero increments of the right sizes.
  bool bordered() const { return solver_.unknowns() > 0; }
  /// Number of free bodies: the size of SystemState::bodies.
  std::size_t free_bodies() const { return border_.count(); }
  const FreeBody& free_body(std::size_t number) const { return border_.body(number); }
  /// Pulls of the wires of the system at the last evaluation.
  const std::vector<WirePull>& wires() const { return border_.wires(); }
  /// Hinged stinger sections at the last evaluation.
  const HingedSections& hinged() const { return border_.hinged(); }

  /// Returns a value that changes with the contact states of any line.
  std::uint64_t contact_signature() const;
  /// True if all contacts are in the states that their laws require.
  bool contacts_settled() const;

  /// Sets the parameters of a continuation in all lines.
  void set(const Continuation& continuation);
  /// Sets surroundings and line ends at a time, without a state.
  void set_surroundings(double time);
  /// Sets the surroundings at a time and moves the rollers; elements in range are found from the lines in `near`.
  void set_time(double time, const SystemState& near);
  /// A tensioner of the system: its drive mode and the pipe's direction there.
  struct Tensioner {
    std::size_t attachment = 0;
    TensionerDrive drive = TensionerDrive::brake;
    Vec3 axis = Vec3::UnitX();  ///< At the last evaluated state.
  };
  const std::vector<Tensioner>& tensioners() const { return tensioners_; }
  /// `tensioner`: its index among tensioners().
  void set_drive(std::size_t tensioner, TensionerDrive drive);
  /// Moves free bodies to a state; sets the positions, directions and rates of the held ends of lines.
  void impose_ends(SystemState& state);
  /// Holds a freedom of a free body (index in System::bodies) constant: its equation is left out.
  void hold_body(int body, int freedom, bool held);
  bool body_held(int body, int freedom) const { return border_.held(body, freedom); }

  /// Evaluates inertia plus internal minus external forces at `state`; its memories are updated from those of `before`
  /// over the step.
  void evaluate(SystemState& state, const SystemState& before, const Weights& weights, bool with_tangent,
                ContactMode contacts = ContactMode::free);
  /// Evaluates internal minus external forces on lines and free bodies at rest, with fixed ends.
  void evaluate_at_rest(SystemState& state, LayHistory history, bool with_tangent);
  /// Sets the held directions of an attachment, instead of its own, until the surroundings change.
  void hold_end(std::size_t attachment, const HeldDirections& held) { held_[attachment] = held; }
  /// Sets the border of a far force: derivative of the forces on the first end by it, and the equation that closes it.
  void put_far_force(std::size_t number, const Vec3& column, const TargetEquation& target);
  /// Holds a far force at its size: its equation is left out.
  void hold_far_force(std::size_t number, bool held);
  /// Updates the factors to the contacts of the last evaluation, which had no tangent: the line's part remains that of
  /// the last factors, which are kept up to the first roller. Returns false if a full tangent is needed.
  bool renew_contacts(const SystemState& state, const Weights& weights);
  /// Factors some lines (nonzero in `which`) anew, with their full tangent at the last evaluated state. Returns false
  /// if one is singular.
  bool renew_lines(SystemState& state, const SystemState& before, const Weights& weights,
                   const std::vector<char>& which);
  /// To be called before a correction from the last evaluation; see RollerContacts.
  void end_iteration(const SystemState& state);
  /// Removes held directions from the residual and, if `with_tangent`, from the blocks.
  void hold(bool with_tangent);
  void hold_line(int line, bool with_tangent);
  /// Returns the maximum residual of a line or a free body over its force scale.
  double relative_residual();
  /// Residual of each line, and last of the free bodies if any, from the last relative_residual().
  const std::vector<double>& residuals() const { return residuals_; }
  /// Its position: line and node; kBodyPlace and the number among free bodies.
  std::pair<int, int> worst_place() const { return worst_; }

  /// Factors the blocks and solves for the increments of the unknowns; returns false if they are singular. For statics:
  /// with masses `factor` and `solve_again` are faster, see BorderedSystem::factor_and_solve().
  bool solve_factored(Increments& dq);
  /// The same for one line alone.
  bool solve_line(int line, Increments& dq);
  /// Factors the blocks; returns false if they are singular.
  bool factor();
  /// Solves for the increments with the last factors of `factor` or `solve_factored`.
  void solve_again(Increments& dq);
  /// Replaces forces on the unknowns by the resulting increments, with the same factors.
  void apply_factors(Increments& dq);
  /// Report of the last factors.
  const BorderedReport& solve_report() const { return solve_report_; }

  /// Returns energies and powers at the last evaluated state.
  InstantEnergy energy(const SystemState& state) const;
  /// Returns the work of all attachments at that state in `ends`, which allocates on the first call only.
  void find_working_ends(const SystemState& state, std::vector<WorkingEnd>& ends) const;
  /// Updates the memories of free bodies at the end of a step of `h` from `before`, and all contacts at the last
  /// evaluated state.
  void finish_step(const SystemState& before, double h, SystemState& after);
  /// Drops the caches of the contacts, so that a restart reproduces the run: for checkpoints.
  void forget_contacts();
  /// Residual forces and generalised moments of the free bodies, six each.
  const std::vector<double>& body_residual() const { return border_.residual(); }

  /// Returns the tension measured by a tensioner [N], by its index: its force along the pipe, which is the effective
  /// tension there.
  double tension(std::size_t tensioner) const;

  /// Computes the true accelerations from the balance of forces at rest or in motion; returns false if the mass matrix
  /// is singular.
  bool find_accelerations(SystemState& state);

 private:
  void hold_attachment(std::size_t index, bool with_tangent);
  bool governed(std::size_t attachment) const;
  bool is_governed(const Tensioner& tensioner) const;
  bool factor_fresh(const SystemState& state, const Weights& weights);
  void take_residual(Increments& dq);
  void point_solution_at(Increments& dq);
  double* border_increments(Increments& dq) const { return bordered() ? dq.back().data() : nullptr; }
  int far_unknown(std::size_t number) const { return border_.unknowns() + static_cast<int>(number); }
  void hold_hinged(int body);
  void set_body_motions(const SystemState& state);
  void evaluate_bodies(SystemState& state, const SystemState& before, const Weights& weights, bool with_tangent);
  void add_body_energy(const SystemState& state, InstantEnergy& sums) const;
  void add_wire_energy(InstantEnergy& sums) const;
  void add_winch_power(const SystemState& state, InstantEnergy& sums) const;
  void pay_out(const SystemState& state);
  void set_held_directions();
  void add_governor(const Tensioner& tensioner, const SystemState& state);
  void add_governor_tangent(const Tensioner& tensioner, const SystemState& state, const Weights& weights);
  void find_axes(const SystemState& state);

  const System* system_;
  Surroundings surroundings_;
  BodyBorder border_;
  BorderedSystem solver_;
  BorderedReport solve_report_;
  std::vector<double> target_errors_;  ///< Errors of the equations that close the far forces.
  std::vector<LineAssembly> lines_;
  std::vector<double*> solution_;     ///< Increments of the lines, for the solver.
  std::vector<HeldDirections> held_;  ///< Per attachment.
  std::vector<Tensioner> tensioners_;
  std::vector<double> residuals_;
  std::vector<int> fresh_from_;  ///< Per line: first node whose blocks were renewed.
  std::pair<int, int> worst_{0, 0};
};

/// Returns a system at rest with its lines in the given shapes, without memories, at `time`.
SystemState state_at_rest(const System& system, const std::vector<std::vector<double>>& q, double time);

}  // namespace overbend
