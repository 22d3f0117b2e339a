/// A model advanced through time step by step, with observers: the one loop that a pipe on its vessel, a hull on its
/// mooring lines and lines by themselves go through.
///
///     Simulation simulation(model, equilibrium, top_tension, options);
///     simulation.observe(recorder);
///     while (simulation.step()) { ... simulation.now() ... simulation.command("tensioner", ...) ... }
///
/// The steps do not depend on the calls: step() again and again, advance() to any times and a whole run give the same
/// results, bit for bit.
///
/// A step calls, in this order: lines that part, controllers; then, tried until one is accepted, the time step,
/// impacts, the tensioner's events, lines that snap, limits of hulls; then the choice of the next step, energy, impacts
/// that ended, the tensioner, observers; at a tick of the clock the waves and rows of output; at last the conveyor.
#pragma once

#include <optional>
#include <vector>

#include "dynamics/integrator/dynamic_clock.h"
#include "dynamics/integrator/dynamics.h"
#include "dynamics/integrator/energy_account.h"
#include "dynamics/integrator/tension_watches.h"
#include "dynamics/integrator/water_field.h"
#include "dynamics/run/controllers.h"
#include "dynamics/run/conveyor.h"
#include "dynamics/run/simulation_observer.h"
#include "dynamics/setup/run_setup.h"

namespace overbend {

class Simulation {
 public:
  /// At rest in the static state, at the beginning of the build-up: that of the pipe, of the hull on its mooring lines
  /// (solve_moored_hull(), by which `model` has its mean pose) or of lines by themselves. `top_tension` is the
  /// effective tension at the tensioner there, where the model has one [N]. The model must outlive it. Throws
  /// std::invalid_argument for a sea or a motion that cannot be made, and for controllers of machines that are not
  /// there. There may be no rest: see failure().
  Simulation(const Model& model, const StaticSolution& start, double top_tension, const DynamicOptions& options);
  /// The same from what make_run_start() gives, or another start of its form: with other ends of lines, say.
  Simulation(const Model& model, RunStart start, const DynamicOptions& options);
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
  /// Names of the mooring lines, which follow the pipe among the lines of the system, and the lines that stand by
  /// themselves, or on the pipe.
  const std::vector<std::string>& moorings() const { return setup_.mooring_names; }
  const std::vector<FollowedLine>& lines() const { return setup_.lines; }
  /// Where the bodies besides the vessel begin among those of the system.
  std::size_t first_body() const { return setup_.first_body; }
  const DynamicOptions& options() const { return options_; }
  /// The way on which the vessel is moved ahead; null where it is not.
  const MoveProfile* move() const { return setup_.move ? &*setup_.move : nullptr; }
  /// The vessel that floats free; null where its motion is prescribed.
  const Hull* hull() const { return setup_.hull ? &setup_.hull->hull : nullptr; }
  /// The present, with the system evaluated at the state: tension, moments, contacts and surroundings can be read.
  Instant now() const;
  /// Force of the tensioner on the pipe; 0 without one [N].
  double tension() const { return pipe_ ? assembly_->tension(0) : 0.0; }
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
  const AttachmentState* tensioner() const { return pipe_ ? &state_.attachments[pipe_->tensioner] : nullptr; }
  const std::vector<RollerContact>& contacts() const;
  void set_drives();
  void surroundings(double time, Surroundings& now);
  void begin();
  double energy_scale() const;
  bool part_lines();
  void ask_controllers();
  bool attempt(double h, double target, double& to_event);
  bool reject(double wanted);
  void accept(double h);
  void reach_tick();
  void convey();
  void renew_system();
  void adapt(double h);
  void evaluate_present();
  void restore_pipe(const DynamicCheckpoint& checkpoint);
  void find_elevation();
  double to_timed_event() const;

  DynamicOptions options_;
  RunSetup setup_;
  Clock clock_;
  std::optional<LaidPipe> pipe_;  ///< Where one is laid.
  Controllers controllers_;
  std::optional<WaterOnLines> water_;
  Vec3 ahead_W_;            ///< Horizontal unit vector ahead along the lay route.
  double elevation_ = 0.0;  ///< Of the water at the setup's place, now [m].
  std::optional<Assembly> assembly_;
  std::optional<TimeStepper> stepper_;
  std::optional<ImpactTracker> tracker_;
  std::optional<Conveyor> conveyor_;  ///< Where the vessel moves ahead.
  EnergyAccount energy_;
  SystemState state_, next_;
  StepChooser chooser_;
  TensionWatches watches_;
  std::vector<EndedImpact> ended_;
  std::vector<EventTry> tried_;  ///< Of the tensioners, within a step.
  DynamicRunReport report_;
  std::optional<StaticFailure> failure_;
  std::vector<SimulationObserver*> observers_;
};

}  // namespace overbend
