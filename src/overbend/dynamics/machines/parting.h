/// Lines that part at an end in mid-run: what held the end lets it go, and the line falls.
#pragma once

#include "system/assembly.h"

namespace overbend {

/// Until the next line parts [s]; infinite where none will.
double time_to_parting(const System& system, const SystemState& state);

/// Parts the lines whose time has come: their ends hang free from here on, in `system` and in `state`. False where
/// there are none.
bool part_due_lines(System& system, SystemState& state);

/// Brings a system to what is parted in a state that was restored.
void part_as_in(const SystemState& state, System& system);

}  // namespace overbend
