/// A system advanced through time step by step: the loop that runs of lines, and whatever else has no pipe, go through.
/// Steps are as long as their error allows, end on the ticks of a clock, and are cut where Newton's method needs it.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "dynamics/integrator/dynamic_clock.h"
#include "dynamics/integrator/energy_account.h"
#include "dynamics/integrator/time_step.h"
#include "dynamics/integrator/water_field.h"
#include "results/dynamic_sink.h"
#include "statics/solver/statics.h"

namespace overbend {

class SystemRun;

/// Who looks on. Told of the instants as they are accepted, and of the rows of output.
class SystemObserver {
 public:
  SystemObserver() = default;
  SystemObserver(const SystemObserver&) = delete;
  SystemObserver& operator=(const SystemObserver&) = delete;
  virtual ~SystemObserver() = default;
  virtual void stepped(const SystemRun& /*run*/) {}
  virtual void row(const SystemRun& /*run*/) {}
  virtual void save(DynamicCheckpoint& /*checkpoint*/) const {}
  virtual void restore(const DynamicCheckpoint& /*checkpoint*/) {}
};

/// Moves bodies whose motion is told, and the ends of the lines of a system as it is at a time: lines may have parted.
using LeadEnds = std::function<void(const System& system, double time, Surroundings& now)>;

class SystemRun {
 public:
  /// `lead` moves what the state does not; waves at the nodes are added here, of `sea`, which must outlive the
  /// run. `start` is the state at rest from which the build-up goes; its time is set here.
  SystemRun(System system, LeadEnds lead, const Sea& sea, SystemState start, const DynamicOptions& options);
  SystemRun(const SystemRun&) = delete;
  SystemRun& operator=(const SystemRun&) = delete;

  void observe(SystemObserver& observer) { observers_.push_back(&observer); }
  /// One accepted step. False at the end of the run, and where no step can be solved (see failure()). Nothing is
  /// allocated.
  bool step();
  /// Steps up to the first instant at or after `until` [s]. False where a step failed.
  bool advance(double until);

  double time() const { return state_.time; }                                                   ///< [s]
  double end() const { return static_cast<double>(clock_.last_tick) * clock_.interval; }        ///< [s]
  double next_row() const { return static_cast<double>(clock_.next_row()) * clock_.interval; }  ///< [s]
  bool finished() const { return clock_.tick >= clock_.last_tick; }
  /// Why it cannot go on; it stays at the last accepted instant.
  const std::optional<StaticFailure>& failure() const { return failure_; }
  const DynamicOptions& options() const { return options_; }
  std::int64_t row_number() const { return clock_.tick / clock_.ticks_per_row; }  ///< Of the last row; 0 at t = 0.
  const System& system() const { return system_; }
  const SystemState& state() const { return state_; }
  /// Evaluated at the state.
  const Assembly& assembly() const { return *assembly_; }
  const EnergyBalance& energy() const { return energy_.balance(); }
  const DynamicRunReport& report() const { return report_; }  ///< Without what a driver knows: ratio and integrator.
  /// Everything that a run of the same arguments and observers needs to go on from here, bit for bit; at a row of
  /// output.
  DynamicCheckpoint checkpoint() const;
  void restore(const DynamicCheckpoint& checkpoint);
  /// Force on a line by what holds its end, W [N].
  Vec3 end_force(std::size_t line, LineEnd end) const;

 private:
  void surroundings(double time, Surroundings& now);
  bool begin();
  bool part_lines();
  bool attempt(double h, double target);
  void accept(double h);
  void adapt(double h);
  double watched_tension(std::size_t watch) const;
  double longest_by_tension(double h) const;
  void reach_tick();

  System system_;
  LeadEnds lead_;
  DynamicOptions options_;
  Clock clock_;
  std::vector<WaterField> water_;  ///< Line by line.
  std::vector<WaterMemory> water_memory_;
  std::optional<Assembly> assembly_;
  std::optional<TimeStepper> stepper_;
  EnergyAccount energy_;
  SystemState state_, next_;
  StepChooser chooser_;
  std::vector<TensionWatch> watches_;  ///< Two for every line.
  DynamicRunReport report_;
  std::optional<StaticFailure> failure_;
  std::vector<SystemObserver*> observers_;
};

}  // namespace overbend
