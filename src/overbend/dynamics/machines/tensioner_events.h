/// Tensioners in a run: state changes at the end of a step, and events that steps must meet.
#pragma once

#include <vector>

#include "mechanics/tensioner.h"
#include "system/assembly.h"

namespace overbend {

/// Records the tensions at the end of a step of `h`, where the assembly has been evaluated, and stops or starts the
/// tensioners in `state`.
void observe_tensions(const Assembly& assembly, double h, SystemState& state);

/// Returns the time until the delay of a controlled tensioner ends [s], at least `min_step`; infinite if none is
/// pending.
double time_to_tensioner(const System& system, const SystemState& state, double min_step);

/// Returns the length of a step of `h` from `from` to `to`, where the assembly has been evaluated, that meets the first
/// event of a controlled tensioner [s], at least `min_step`. `tried` holds per tensioner the previous attempt and
/// receives this one.
double step_to_tensioner(const Assembly& assembly, double h, const SystemState& from, const SystemState& to,
                         double min_step, std::vector<EventTry>& tried);

}  // namespace overbend
