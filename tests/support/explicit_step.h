/// A second integrator, to hold the first against: explicit central differences.
#pragma once

#include "system/assembly.h"

namespace overbend {

/// From `now`, whose accelerations are in balance, over `h` to `next` by central differences in the form with
/// velocities at whole steps (velocity Verlet):
///
///     q_{n+1} = q_n + h v_n + h^2/2 q''_n
///     v*      = v_n + h q''_n                            where forces ask for the velocity
///     q''_{n+1} from the balance at (q_{n+1}, v*)        with the consistent mass, one block-tridiagonal solution
///     v_{n+1} = v_n + h/2 (q''_n + q''_{n+1})
///
/// Second order, no damping of its own, and stable only while h is below 2 over the highest frequency of the line and
/// its contacts. Memories of contact and friction go forward as with the implicit scheme. The system is left evaluated
/// at `next`. False where the mass is singular or a number is no longer finite.
bool explicit_step(Assembly& assembly, const SystemState& state, double h, SystemState& next);

}  // namespace overbend
