/// Stages of an operation on the line as lines on the terminal.
#pragma once

#include <string>

#include "model/description/description.h"
#include "results/operation_results.h"

namespace overbend {

/// Heads of the columns, two lines.
std::string stage_heads(OperationType type);

/// One stage: how far out, tension, depth of the head, the sagbend's stress and strain, clearance at the stinger tip,
/// the check used most; or why it cannot be.
std::string stage_line(const StageResult& stage);

/// The stages that a model has, for `overbend check`; what is found only by solving is said so.
std::string planned_stages(const Description& description);

}  // namespace overbend
