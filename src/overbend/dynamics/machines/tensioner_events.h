/// The tensioner in a run: what it does at the end of a step, and the instants that steps have to meet for it.
#pragma once

#include "mechanics/tensioner.h"
#include "system/assembly.h"

namespace overbend {

/// Takes the tension at the end of a step of `h`, at which the assembly stands evaluated, and stops or starts the
/// machine in `state`. Nothing where the system has no tensioner.
void observe_tension(const Assembly& assembly, double h, SystemState& state);

/// Until a controlled tensioner's delay is over [s]; infinite where there is none to wait for. `least`: no shorter.
double time_to_tensioner(const System& system, const SystemState& state, double least);

/// How long a step of `h` from `from` to `to`, at which the assembly stands evaluated, may be to meet the instant at
/// which its tension makes a controlled tensioner change [s]; `least` is the shortest. `tried` is the try before, and
/// becomes this one.
double step_to_tensioner(const Assembly& assembly, double h, const SystemState& from, const SystemState& to,
                         double least, EventTry& tried);

}  // namespace overbend
