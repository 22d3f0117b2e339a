/// Dynamic relaxation with kinetic damping: the way the source work finds its first equilibrium.
#pragma once

#include "statics/equations/static_system.h"

namespace overbend {

struct RelaxationSettings {
  int max_steps = 40000;
  double tolerance = 1e-4;  ///< Largest unbalanced nodal force over the total weight, to hand over to Newton.
};

struct RelaxationReport {
  int steps = 0;
  double residual = 0.0;
  bool diverged = false;  ///< The pipe was torn apart: no place that Newton could go on from.
};

/// Marches a fictitious motion with lumped masses chosen for the largest stable unit step (Gershgorin bound on the
/// tangent) and sets all velocities to zero at every peak of the kinetic energy (Cundall 1976; Barnes 1999).
/// Matrix-free between the renewals of the masses, at which it is also seen whether the motion diverges. The far force
/// stays.
RelaxationReport relax(StaticSystem& system, LineState& state, const RelaxationSettings& settings);

}  // namespace overbend
