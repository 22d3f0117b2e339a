/// The balance of energy over a run.
#pragma once

#include <vector>

#include "mechanics/strain_points.h"
#include "results/dynamic_results.h"
#include "system/assembly.h"

namespace overbend {

/// Of the lines and, where bodies are free, of these with them. Stored energies are exact at each instant; powers are
/// integrated by the trapezoidal rule, but for what ends do that no free body holds, and what the internal damping of
/// lines takes: that is the mean force of a step times the way, exact for a constant force. What the time integrator
/// damps appears as error.
class EnergyAccount {
 public:
  void start(const Assembly& assembly, const SystemState& state, double least, bool free_bodies);
  /// `least` energy counts as passed from the start, so that a pipe at rest does not drift by its rounding [J].
  void start(const InstantEnergy& first, double least, bool free_bodies = false);
  /// The state after a step of `h`. Does not allocate.
  void add(const Assembly& assembly, const SystemState& state, double h);
  void add(const InstantEnergy& now, double h);
  void carry(const InstantEnergy& before, const Assembly& assembly, const SystemState& state);
  /// What the sums are at the instant of the last step once material has come in or gone, which is no work.
  void carry(const InstantEnergy& before, const InstantEnergy& after);
  const EnergyBalance& balance() const { return balance_; }

  std::vector<double> save() const;
  /// Of an account that was started on the same system.
  void restore(const std::vector<double>& saved);

 private:
  void find_ways(const Assembly& assembly, const SystemState& state);
  double along_the_way(bool last, double h) const;
  double strained(double h) const;

  InstantEnergy first_, last_;
  std::vector<WorkingEnd> last_ends_, ends_;
  std::vector<StrainPoint> last_points_, points_;
  EnergyBalance balance_;
};

}  // namespace overbend
