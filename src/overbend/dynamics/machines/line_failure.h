/// Line failure at an end during a run: the attachment releases the end, and the line falls.
#pragma once

#include "system/assembly.h"

namespace overbend {

/// Returns the time to the next line failure [s]; infinite if there is none.
double time_to_line_failure(const System& system, const SystemState& state);

/// Releases the ends of lines whose failure time has come, in `system` and in `state`. Returns false if there are none.
bool fail_due_lines(System& system, SystemState& state);

/// Releases in `system` the line ends that are parted in a restored state.
void restore_failed_lines(const SystemState& state, System& system);

}  // namespace overbend
