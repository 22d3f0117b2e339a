/// A dynamic analysis advanced step by step, with observers.
///
///     Simulation simulation(model, equilibrium, top_tension, options);
///     simulation.observe(recorder);
///     while (simulation.step()) { ... simulation.now() ... simulation.command("tensioner", ...) ... }
///
/// The steps do not depend on the calls: step() again and again, advance() to any times and a whole run give the same
/// results, bit for bit.
#pragma once

#include <optional>
#include <vector>

#include "dynamics/integrator/dynamic_clock.h"
#include "dynamics/integrator/dynamics.h"
#include "dynamics/integrator/energy_account.h"
#include "dynamics/integrator/water_field.h"
#include "dynamics/run/controllers.h"
#include "dynamics/run/conveyor.h"
#include "dynamics/run/simulation_observer.h"
#include "dynamics/setup/run_setup.h"

namespace overbend {

class Simulation {
 public:
  /// At rest in the static state, at the beginning of the build-up. `top_tension` is the effective tension at the
  /// tensioner there [N]. Throws std::invalid_argument for a sea or a motion that cannot be made, and for controllers
  /// of machines that are not there.
  Simulation(const Model& model, const StaticSolution& start, double top_tension, const DynamicOptions& options);
  Simulation(const Simulation&) = delete;
  Simulation& operator=(const Simulation&) = delete;

  /// Adds an observer, which is told of the present state and of everything from here on. It has to outlive all further
  /// calls.
  void observe(SimulationObserver& observer);

  /// One accepted step; shorter ones are tried until one is accepted. False where there is none: at the end of the run,
  /// and where no step can be solved (see failure()). Nothing is allocated but where pipe that was paid out becomes a
  /// node.
  bool step();
  /// Steps up to the first instant at or after `until` [s], the end of the run at most. Rows of output are met exactly,
  /// other times by the step that passes them. False where a step failed.
  bool advance(double until);

  double time() const { return state_.time; }                                                   ///< [s]
  double end() const { return static_cast<double>(clock_.last_tick) * clock_.interval; }        ///< [s]
  double next_row() const { return static_cast<double>(clock_.next_row()) * clock_.interval; }  ///< [s]
  std::int64_t row_number() const { return clock_.tick / clock_.ticks_per_row; }  ///< Of the last row; 0 at t = 0.
  bool finished() const { return clock_.tick >= clock_.last_tick; }
  /// Why it cannot go on; it stays at the last accepted instant.
  const std::optional<StaticFailure>& failure() const { return failure_; }

  const System& system() const { return setup_.system; }
  /// Those of the supports, in their order, whichever body carries them.
  const std::vector<BodyRoller>& rollers() const { return setup_.rollers; }
  /// Names of the mooring lines, which follow the pipe among the lines of the system.
  const std::vector<std::string>& moorings() const { return setup_.mooring_names; }
  const DynamicOptions& options() const { return options_; }
  /// The way on which the vessel is moved ahead; null where it is not.
  const MoveProfile* move() const { return setup_.move ? &*setup_.move : nullptr; }
  /// The vessel that floats free; null where its motion is told.
  const Hull* hull() const { return setup_.hull ? &setup_.hull->hull : nullptr; }
  /// The present, with the system evaluated at the state: tension, moments, contacts and surroundings can be read.
  Instant now() const;
  double tension() const { return assembly_->machine_tension(); }  ///< Force of the tensioner on the pipe [N].
  const EnergyBalance& energy() const { return energy_.balance(); }
  const DynamicRunReport& report() const { return report_; }  ///< Without what a driver knows: ratio and integrator.

  /// The tension that the tensioner restores from here on; its operational range is shifted with it. A locked one holds
  /// the pipe whatever it is set to. [N]
  void set_tension(double wanted);
  /// What a machine shall do from here on, or until its controller says otherwise. The tensioner takes commands always,
  /// a mooring winch where DynamicOptions::controllers names it. Throws std::invalid_argument for what it cannot do.
  void command(const std::string& machine, const MachineCommand& command);
  const Controllers& controllers() const { return controllers_; }

  /// Everything that a simulation of the same arguments needs to go on from here, observers included, bit for bit.
  /// Exact at a row of output: between two the steps after it may differ within their tolerance.
  DynamicCheckpoint checkpoint() const;
  /// With the same observers as when it was made.
  void restore(const DynamicCheckpoint& checkpoint);

 private:
  Simulation(const Model& model, const DynamicOptions& options, const StaticSolution& start, double top_tension);
  const Line& pipe() const { return setup_.system.lines.front(); }
  const std::vector<RollerContact>& contacts() const { return assembly_->line(0).contacts().contacts(); }
  AttachmentState& tensioner(SystemState& state) const { return state.attachments[machine()]; }
  const AttachmentState& tensioner(const SystemState& state) const { return state.attachments[machine()]; }
  std::size_t machine() const { return static_cast<std::size_t>(setup_.system.machine); }
  TensionerLaw& set_law() { return setup_.system.attachments[machine()].tensioner; }
  void surroundings(double time, Surroundings& now);
  bool begin();
  void let_hull_go();
  void rest_moorings();
  bool part_lines();
  void ask_controllers();
  bool attempt(double h, double target, double& to_event, EventTry& tried);
  bool reject(double wanted);
  void accept(double h);
  void reach_tick();
  void convey();
  void renew_system();
  void adapt(double h);
  void evaluate_present();
  void restore_pipe(const DynamicCheckpoint& checkpoint);
  void observe_tension(SystemState& state, double h);
  void find_elevation();
  double to_timed_event() const;
  double step_to_tensioner(double h, EventTry& tried) const;

  DynamicOptions options_;
  RunSetup setup_;
  Clock clock_;
  Controllers controllers_;
  std::vector<WaterField> water_;  ///< Line by line.
  std::vector<WaterMemory> water_memory_;
  Vec3 shoe_;               ///< Mean place of the stern shoe before any move, W [m].
  Vec3 ahead_W_;            ///< Horizontal unit vector ahead along the lay route.
  double elevation_ = 0.0;  ///< Of the water there, now [m].
  std::optional<Assembly> assembly_;
  std::optional<TimeStepper> stepper_;
  std::optional<ImpactTracker> tracker_;
  std::optional<Conveyor> conveyor_;  ///< Where the vessel moves ahead.
  EnergyAccount energy_;
  SystemState state_, next_;
  StepChooser chooser_;
  TensionWatch watch_;
  std::vector<EndedImpact> ended_;
  DynamicRunReport report_;
  std::optional<StaticFailure> failure_;
  std::vector<SimulationObserver*> observers_;
};

}  // namespace overbend
