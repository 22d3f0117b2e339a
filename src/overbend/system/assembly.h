/// The equations of a system in motion at one instant: what its lines, their ends and the tensioners at them add up
/// to.
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
  double roller_power = 0.0;                       ///< Of the moving rollers on the pipe [W].
  double contact_loss = 0.0, friction_loss = 0.0;  ///< [W]
  double top_power = 0.0, anchor_power = 0.0;      ///< Of what holds last and first ends [W].
  double bending_heat = 0.0;                       ///< Made by yielding so far [J].
  BodyEnergy bodies;                               ///< Of the free ones; what lines do to them is no power here.
};

/// The end of an attachment; free bodies that hold one count for no force.
struct WorkingEnd {
  bool last = false;                       ///< Of the line's ends.
  std::array<double, 6> force{}, place{};  ///< On the line, and its unknowns.
  double power = 0.0;                      ///< [W]
};

/// Unknowns of every line, six per node; where there is a border, another entry at the end: six for each free body,
/// then the far forces.
using Increments = std::vector<std::vector<double>>;

/// The equation that closes a far force, to first order: gradient . change = -error, of one node of its line.
struct TargetEquation {
  int node = 0;
  bool tangent = false;  ///< Of its unknowns: the tangent, else the position.
  Vec3 gradient = Vec3::Zero();
  double error = 0.0;  ///< Value minus target.
};

inline constexpr int kBodyPlace = -1;  ///< In place of a line: a free body.

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
  bool bordered() const { return solver_.unknowns() > 0; }
  /// How many bodies are free: the size of SystemState::bodies.
  std::size_t free_bodies() const { return border_.count(); }
  const FreeBody& free_body(std::size_t number) const { return border_.body(number); }
  /// Of the wires of the system, as the last evaluation left them.
  const std::vector<WirePull>& wires() const { return border_.wires(); }
  /// Sections of a stinger on hinges, as the last evaluation left them.
  const HingedSections& hinged() const { return border_.hinged(); }

  std::uint64_t contact_signature() const;
  bool contacts_settled() const;

  /// Sets the parameters of a continuation in all lines.
  void set(const Continuation& continuation);
  /// Brings the surroundings and what holds the ends to a time, without a state.
  void set_surroundings(double time);
  /// Brings the surroundings to a time, and the rollers to the lines as they are in `near`.
  void set_time(double time, const SystemState& near);
  /// A tensioner of the system: what decides its speed at the instants to come, and the pipe's direction there.
  struct Tensioner {
    std::size_t attachment = 0;
    TensionerDrive drive = TensionerDrive::brake;
    Vec3 axis = Vec3::UnitX();  ///< At the state evaluated last.
  };
  const std::vector<Tensioner>& tensioners() const { return tensioners_; }
  /// By the tensioner's number among these.
  void set_drive(std::size_t tensioner, TensionerDrive drive);
  /// Brings free bodies to a state; puts the places, directions and rates of what holds them into the ends of lines.
  void impose_ends(SystemState& state);
  /// A freedom of a free body (index in System::bodies) that stays where it is: its equation is left out.
  void hold_body(int body, int freedom, bool held);
  bool body_held(int body, int freedom) const { return border_.held(body, freedom); }

  /// Inertia plus internal minus external forces at `state`; its memories receive what those of `before` have become
  /// after the step.
  void evaluate(SystemState& state, const SystemState& before, const Weights& weights, bool with_tangent,
                ContactMode contacts = ContactMode::free);
  /// Internal minus external forces on lines and free bodies at rest, ends where they are.
  void evaluate_at_rest(SystemState& state, LayHistory history, bool with_tangent);
  /// Holds the end of an attachment so, in place of what the attachment says, until the surroundings change.
  void hold_end(std::size_t attachment, const HeldDirections& held) { held_[attachment] = held; }
  /// The border of a far force: how the forces on the first end change with it, and the equation that closes it.
  void put_far_force(std::size_t number, const Vec3& column, const TargetEquation& target);
  /// A far force that is held keeps its size; its equation is left out.
  void hold_far_force(std::size_t number, bool held);
  /// Brings the factors up to the contacts of the last evaluation, which had no tangent: the lines' part is that of the
  /// last factors, and those before the first roller stand. False where a full tangent is needed.
  bool renew_contacts(const SystemState& state, const Weights& weights);
  /// Factors some lines (not zero in `which`) anew, with their full tangent at the state evaluated last. False where
  /// one is singular.
  bool renew_lines(SystemState& state, const SystemState& before, const Weights& weights,
                   const std::vector<char>& which);
  /// Before a correction that the last evaluation led to; see RollerContacts.
  void end_iteration(const SystemState& state);
  /// Removes held directions from residual and, where asked, blocks.
  void hold(bool with_tangent);
  void hold_line(int line, bool with_tangent);
  /// Largest unbalanced force of a line or a free body over its force scale.
  double relative_residual();
  /// The same, of each line, and at the end of the free bodies where there are any: as relative_residual() found them.
  const std::vector<double>& residuals() const { return residuals_; }
  /// Where it was found: line and node; kBodyPlace and the number among free bodies.
  std::pair<int, int> worst_place() const { return worst_; }

  /// Factors the blocks and solves for the increments of the unknowns; false where they are singular. For statics: with
  /// masses `factor` and `solve_again` are less work, see BorderedSystem::factor_and_solve().
  bool solve_factored(Increments& dq);
  /// The same of one line by itself.
  bool solve_line(int line, Increments& dq);
  /// Factors the blocks; false where they are singular.
  bool factor();
  /// Solves for the increments with the factors of the last `factor` or `solve_factored`.
  void solve_again(Increments& dq);
  /// Replaces forces on the unknowns by the increments that they make, with the same factors.
  void apply_factors(Increments& dq);
  /// Of the last factors.
  const BorderedReport& solve_report() const { return solve_report_; }

  /// Of the state evaluated last.
  InstantEnergy energy(const SystemState& state) const;
  /// Likewise, of all attachments; `ends` allocates the first time alone.
  void find_working_ends(const SystemState& state, std::vector<WorkingEnd>& ends) const;
  /// Brings the memories of free bodies to the end of a step of `h` that began at `before`, and all contacts up to the
  /// state, which was evaluated last.
  void finish_step(const SystemState& before, double h, SystemState& after);
  /// What comes next depends on states alone: for checkpoints.
  void forget_contacts();
  /// Forces and generalised moments left on the free bodies, six each.
  const std::vector<double>& body_residual() const { return border_.residual(); }

  /// What a tensioner measures, by its number: its force along the pipe, which is the effective tension there [N].
  double tension(std::size_t tensioner) const;

  /// True accelerations from the balance of forces at rest or in motion; false where the mass is singular.
  bool find_accelerations(SystemState& state);

 private:
  void hold_attachment(std::size_t index, bool with_tangent);
  bool governed(std::size_t attachment) const;
  bool is_governed(const Tensioner& tensioner) const;
  bool factor_fresh(const SystemState& state, const Weights& weights);
  void take_residual(Increments& dq);
  void point_solution_at(Increments& dq);
  double* border_of(Increments& dq) const { return bordered() ? dq.back().data() : nullptr; }
  int far_unknown(std::size_t number) const { return border_.unknowns() + static_cast<int>(number); }
  void hold_hinged(int body);
  void lead_bodies(const SystemState& state);
  void evaluate_bodies(SystemState& state, const SystemState& before, const Weights& weights, bool with_tangent);
  void add_body_energy(const SystemState& state, InstantEnergy& now) const;
  void add_wire_energy(InstantEnergy& now) const;
  void add_winch_power(const SystemState& state, InstantEnergy& now) const;
  void pay_out(const SystemState& state);
  void find_held();
  void add_governor(const Tensioner& tensioner, const SystemState& state);
  void add_governor_tangent(const Tensioner& tensioner, const SystemState& state, const Weights& weights);
  void find_axes(const SystemState& state);

  const System* system_;
  Surroundings surroundings_;
  BodyBorder border_;
  BorderedSystem solver_;
  BorderedReport solve_report_;
  std::vector<double> target_errors_;  ///< Of the equations that close the far forces.
  std::vector<LineAssembly> lines_;
  std::vector<double*> solution_;     ///< Of the lines, for the solver.
  std::vector<HeldDirections> held_;  ///< By the attachments.
  std::vector<Tensioner> tensioners_;
  std::vector<double> residuals_;
  std::vector<int> fresh_from_;  ///< By lines: the first node whose blocks were put in afresh.
  std::pair<int, int> worst_{0, 0};
};

/// A system at rest with its lines in the given shapes, memories empty, at `time`.
SystemState state_at_rest(const System& system, const std::vector<std::vector<double>>& q, double time);

}  // namespace overbend
