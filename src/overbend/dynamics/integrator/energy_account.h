/// Energy balance of a run.
#pragma once

#include <vector>

#include "mechanics/strain_points.h"
#include "results/dynamic_results.h"
#include "system/assembly.h"

namespace overbend {

/// Energy balance of the lines and, if bodies are free, of the bodies. Stored energies are exact at each instant.
/// Powers are integrated by the trapezoidal rule, except for the work on ends not held by a free body and the internal
/// damping of lines: these use the mean force of a step times the displacement, which is exact for a constant force.
/// Numerical damping of the time integrator appears as error.
class EnergyAccount {
 public:
  /// Starts the balance at `state`, to which the assembly has been evaluated.
  void start(const Assembly& assembly, const SystemState& state, double min_energy, bool free_bodies);
  /// `min_energy` is the initial energy throughput, so that round-off of a pipe at rest does not count as drift [J].
  void start(const InstantEnergy& first, double min_energy, bool free_bodies = false);
  /// Adds the state after a step of `h`. Does not allocate.
  void add(const Assembly& assembly, const SystemState& state, double h);
  void add(const InstantEnergy& instant, double h);
  void carry(const InstantEnergy& before, const Assembly& assembly, const SystemState& state);
  /// Adjusts the sums at the instant of the last step for material that was added or removed, which is no work.
  void carry(const InstantEnergy& before, const InstantEnergy& after);
  const EnergyBalance& balance() const { return balance_; }

  std::vector<double> save() const;
  /// Restores an account that was started on the same system.
  void restore(const std::vector<double>& saved);

 private:
  void find_work_points(const Assembly& assembly, const SystemState& state);
  double work_along_displacement(bool last, double h) const;
  double damping_loss_along_strain(double h) const;

  InstantEnergy first_, last_;
  std::vector<WorkingEnd> last_ends_, ends_;
  std::vector<StrainPoint> last_points_, points_;
  EnergyBalance balance_;
};

}  // namespace overbend
