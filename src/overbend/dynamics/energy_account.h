/// The balance of energy over a run.
#pragma once

#include <vector>

#include "results/dynamic_results.h"
#include "system/assembly.h"

namespace overbend {

/// Of the lines and, where bodies are free, of these with them. Stored energies are exact at each instant; powers are
/// integrated by the trapezoidal rule. What the time integrator damps appears as error.
class EnergyAccount {
 public:
  /// `least` energy counts as passed from the start, so that a pipe at rest does not drift by its rounding [J].
  void start(const InstantEnergy& first, double least, bool free_bodies = false);
  /// The state after a step of `h`.
  void add(const InstantEnergy& now, double h);
  /// What the sums are at the instant of the last step once material has come in or gone, which is no work.
  void carry(const InstantEnergy& before, const InstantEnergy& after);
  const EnergyBalance& balance() const { return balance_; }

  std::vector<double> save() const;
  void restore(const std::vector<double>& saved);

 private:
  InstantEnergy first_, last_;
  EnergyBalance balance_;
};

}  // namespace overbend
