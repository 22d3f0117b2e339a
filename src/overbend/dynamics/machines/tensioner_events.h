/// Tensioners in a run: what they do at the end of a step, and the instants that steps have to meet for them.
#pragma once

#include <vector>

#include "mechanics/tensioner.h"
#include "system/assembly.h"

namespace overbend {

/// Take the tension at the end of a step of `h`, at which the assembly stands evaluated, and stop or start the machines
/// in `state`.
void observe_tensions(const Assembly& assembly, double h, SystemState& state);

/// Until the delay of a controlled tensioner is over [s]; infinite where there is none to wait for. `least`: no
/// shorter.
double time_to_tensioner(const System& system, const SystemState& state, double least);

/// How long a step of `h` from `from` to `to`, at which the assembly stands evaluated, may be to meet the instant at
/// which its tension makes a controlled tensioner change [s]; `least` is the shortest. `tried`: of every tensioner the
/// try before, which becomes this one.
double step_to_tensioner(const Assembly& assembly, double h, const SystemState& from, const SystemState& to,
                         double least, std::vector<EventTry>& tried);

}  // namespace overbend
