/// Dynamic relaxation with kinetic damping: the method by which the source work finds its first equilibrium.
#pragma once

#include "statics/equations/static_system.h"

namespace overbend {

struct RelaxationSettings {
  int max_steps = 40000;
  double tolerance = 1e-4;  ///< Largest unbalanced nodal force over the total weight at which Newton's method takes
                            ///< over.
};

struct RelaxationReport {
  int steps = 0;
  double residual = 0.0;
  bool diverged = false;  ///< The elements were torn apart: not a state from which Newton's method could continue.
};

/// Integrates a fictitious motion with lumped masses chosen for the largest stable unit step (Gershgorin bound on the
/// tangent) and sets all velocities to zero at every peak of the kinetic energy (Cundall 1976; Barnes 1999). Matrix-
/// free between renewals of the masses, at which divergence is tested as well. The far force is constant.
RelaxationReport relax(StaticSystem& system, LineState& state, const RelaxationSettings& settings);

}  // namespace overbend
