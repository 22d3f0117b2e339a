/// A pull-ahead of a moored hull in time.
#pragma once

#include "statics/solver/statics.h"
#include "system/system.h"

namespace overbend {

/// Lengths in time of all lines, in the order of the spread; none where the model has no such operation.
std::vector<LengthTable> winch_programs(const StaticSolution& start);

/// Gives the winches of lines of elements their programs. `system`: with the mooring lines of `spread` that are there,
/// behind the pipe where there is one. A winch that keeps a tension goes on doing so.
void follow_programs(const MooringSpread& spread, const std::vector<LengthTable>& programs, System& system);

}  // namespace overbend
