/// Pull-ahead of a moored hull in dynamics.
#pragma once

#include "statics/solver/statics.h"
#include "system/system.h"

namespace overbend {

/// Returns the lengths over time of all lines, in the order of the spread; empty if the model has no such operation.
std::vector<LengthTable> winch_programs(const StaticSolution& start);

/// Sets the programs of the winches of lines of elements. `system`: with the intact mooring lines of `spread`, after
/// the pipe if there is one. A constant-tension winch keeps its mode.
void set_winch_programs(const MooringSpread& spread, const std::vector<LengthTable>& programs, System& system);

}  // namespace overbend
