/// Text of the stages of an operation for the terminal.
#pragma once

#include <string>

#include "app/exit_code.h"
#include "model/description/description.h"
#include "results/operation_results.h"

namespace overbend {

/// Returns the column headings, two lines.
std::string stage_heads(OperationType type);

/// Returns one stage: payout, tension, depth of the head, stress and strain of the sagbend, clearance at the stinger
/// tip and governing check; or the reason why it has no equilibrium.
std::string stage_line(const StageResult& stage);

/// Returns the planned stages of a model for `overbend check`; values that need a solution are marked.
std::string planned_stages(const Description& description);

/// Returns the number of stages with an equilibrium.
int count_solved(const OperationResults& results);

/// Returns kCheckExceeded, with a message on stderr, if `strict` is set and the verdict on the operation is exceeded or
/// reserved; kDone otherwise.
ExitCode strict_code(const OperationResults& results, bool strict);

}  // namespace overbend
