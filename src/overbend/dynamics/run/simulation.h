/// Step-by-step time-domain simulation of a model with observers: one loop for a pipe on its vessel, a hull on its
/// mooring lines and lines alone.
///
///     Simulation simulation(model, equilibrium, top_tension, options);
///     simulation.observe(recorder);
///     while (simulation.step()) { ... simulation.present() ... simulation.command("tensioner", ...) ... }
///
/// The steps do not depend on the calls: repeated step(), advance() to any times and a whole run give the same results,
/// bit for bit.
/// || Order within a step: line failures and controllers; then, repeated until a step is accepted, the time step,
/// impacts, tensioner events, snapping lines, hull limits; then the choice of the next step, energy, ended impacts, the
/// tensioner, observers; at a clock tick the waves and output steps; finally the conveyor.
#pragma once

#include <optional>
#include <vector>

#include "dynamics/integrator/dynamic_clock.h"
#include "dynamics/integrator/dynamics.h"
#include "dynamics/integrator/energy_account.h"
#include "dynamics/integrator/tension_monitors.h"
#include "dynamics/integrator/water_field.h"
#include "dynamics/run/controllers.h"
#include "dynamics/run/conveyor.h"
#include "dynamics/run/simulation_observer.h"
#include "dynamics/setup/run_setup.h"

namespace overbend {

class Simulation {
 public:
  /// Starts at rest in the static equilibrium of the pipe, of the hull on its mooring lines (solve_moored_hull(), which
  /// sets the mean pose of `model`) or of lines alone, at the beginning of the build-up. `top_tension`: effective
  /// tension at the tensioner, if there is one [N]. `model` must outlive this. Throws std::invalid_argument if the sea
  /// or a motion cannot be generated, or if a controller names an unknown machine. If there is no equilibrium, see
  /// failure().
  Simulation(const Model& model, const StaticSolution& start, double top_tension, const DynamicOptions& options);
  /// The same from the result of make_run_start(), or from a modified one, for example with other line ends.
  Simulation(const Model& model, RunStart start, const DynamicOptions& options);
  Simulation(const Simulation&) = delete;
  Simulation& operator=(const Simulation&) = delete;

  /// Adds an observer, which receives the present state and everything from then on. It must outlive all further calls.
  void observe(SimulationObserver& observer);

  /// Takes one accepted step; shorter ones are tried until one is accepted. Returns false at the end of the run and if
  /// no step can be solved (see failure()). Allocates only when paid-out pipe becomes an element.
  bool step();
  /// Steps to the first instant at or after `until` [s], at most to the end of the run. Output steps are met exactly,
  /// other times are passed by the last step. Returns false if a step failed.
  bool advance(double until);

  double time() const { return state_.time; }                                                   ///< [s]
  double end() const { return static_cast<double>(clock_.last_tick) * clock_.interval; }        ///< [s]
  double next_row() const { return static_cast<double>(clock_.next_row()) * clock_.interval; }  ///< [s]
  /// Number of the last output step; 0 at t = 0.
  std::int64_t row_number() const { return clock_.tick / clock_.ticks_per_row; }
  bool finished() const { return clock_.tick >= clock_.last_tick; }
  /// Reason why the run cannot continue; it stays at the last accepted instant.
  const std::optional<StaticFailure>& failure() const { return failure_; }

  const System& system() const { return setup_.system; }
  /// Rollers in the order of the supports, of any body.
  const std::vector<BodyRoller>& rollers() const { return setup_.rollers; }
  /// Names of the mooring lines, which follow the pipe among the lines of the system.
  const std::vector<std::string>& moorings() const { return setup_.mooring_names; }
  /// Free lines and wires, also those on the pipe.
  const std::vector<FollowedLine>& lines() const { return setup_.lines; }
  /// Index of the first body other than the vessel among those of the system.
  std::size_t first_body() const { return setup_.first_body; }
  const DynamicOptions& options() const { return options_; }
  /// Profile of the vessel's move ahead; null if it does not move.
  const MoveProfile* move() const { return setup_.move ? &*setup_.move : nullptr; }
  /// Hull of a floating vessel; null if its motion is prescribed.
  const Hull* hull() const { return setup_.hull ? &setup_.hull->hull : nullptr; }
  /// Returns the present instant with the system evaluated at its state, so that tension, moments, contacts and
  /// surroundings can be read.
  Instant present() const;
  /// Force of the tensioner on the pipe; 0 without a tensioner [N].
  double tension() const { return pipe_ ? assembly_->tension(0) : 0.0; }
  const EnergyBalance& energy() const { return energy_.balance(); }
  /// Real-time ratio and integrator name are filled in by the caller.
  const DynamicRunReport& report() const { return report_; }

  /// Sets the target tension of the tensioner from now on; its operating range is shifted with it. A locked tensioner
  /// holds the pipe regardless of it. [N]
  void set_tension(double wanted);
  /// Commands a machine from now on, or until its controller is called. The tensioner always takes commands, a mooring
  /// winch only if DynamicOptions::controllers names it. Throws std::invalid_argument if it cannot execute the command.
  void command(const std::string& machine, const MachineCommand& command);
  const Controllers& controllers() const { return controllers_; }

  /// Returns everything that a simulation with the same arguments needs to continue from here bit for bit, observers
  /// included. Exact at an output step; in between, later steps may differ within their tolerance.
  DynamicCheckpoint checkpoint() const;
  /// Requires the observers of the saved run.
  void restore(const DynamicCheckpoint& checkpoint);

 private:
  const AttachmentState* tensioner() const { return pipe_ ? &state_.attachments[pipe_->tensioner] : nullptr; }
  const std::vector<RollerContact>& contacts() const;
  void set_drives();
  void surroundings(double time, Surroundings& target);
  void begin();
  double energy_scale() const;
  bool fail_lines();
  void call_controllers();
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
  double time_to_event() const;

  DynamicOptions options_;
  RunSetup setup_;
  Clock clock_;
  std::optional<LaidPipe> pipe_;  ///< Empty without a pipe.
  Controllers controllers_;
  std::optional<WaterOnLines> water_;
  Vec3 ahead_W_;            ///< Horizontal unit vector ahead along the lay route.
  double elevation_ = 0.0;  ///< Water elevation at the setup's water_place [m].
  std::optional<Assembly> assembly_;
  std::optional<TimeStepper> stepper_;
  std::optional<ImpactTracker> tracker_;
  std::optional<Conveyor> conveyor_;  ///< Only if the vessel moves ahead.
  EnergyAccount energy_;
  SystemState state_, next_;
  StepSizeController chooser_;
  TensionMonitors monitors_;
  std::vector<EndedImpact> ended_;
  std::vector<EventTry> tried_;  ///< Per tensioner, within a step.
  DynamicRunReport report_;
  std::optional<StaticFailure> failure_;
  std::vector<SimulationObserver*> observers_;
};

}  // namespace overbend
