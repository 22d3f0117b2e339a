/// Tensions that limit the steps of a run: those of the tensioners if there are any, else those at the held ends of all
/// lines and of wires.
#pragma once

#include <vector>

#include "dynamics/integrator/dynamic_clock.h"
#include "system/assembly.h"

namespace overbend {

/// Step limits from the monitored tensions of a system.
class TensionMonitors {
 public:
  /// `time_scale` is DynamicOptions::time_scale [s].
  TensionMonitors(const System& system, double time_scale);

  /// Starts at the beginning of a run, where the assembly has been evaluated.
  void start(const Assembly& assembly);
  /// Returns the maximum step [s] allowed by the tensions after one of `h` that led to the evaluated state.
  double max_allowed_step(const Assembly& assembly, double h) const;
  /// True if a step of `h` must be repeated because the tensions require one of `max_step`: a line snapped tight within
  /// it.
  bool snapped(double h, double max_step) const;
  /// Records an accepted step of `h`.
  void took(const Assembly& assembly, double h);
  /// Resets the tensions to their present values, after a change that was no step.
  void renew(const Assembly& assembly);

  std::vector<double> save() const;
  void restore(const std::vector<double>& saved);

 private:
  double tension(const Assembly& assembly, std::size_t watch) const;

  /// A tensioner by number, a line end, or a wire.
  struct MonitoredTension {
    int tensioner = -1, line = -1, wire = -1;
    LineEnd end = LineEnd::first;
  };
  static std::vector<MonitoredTension> find_monitored_tensions(const System& system);

  std::vector<MonitoredTension> monitored_;
  MinSteps min_steps_;
  bool follows_snaps_;
  std::vector<TensionMonitor> monitors_;  ///< One per monitored tension.
};

}  // namespace overbend
