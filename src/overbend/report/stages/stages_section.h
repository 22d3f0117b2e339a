/// The stages of an operation on the line: figures, tables, checks.
#pragma once

#include <string>

#include "report/page/blocks.h"
#include "results/operation_results.h"

namespace overbend {

/// All stages in figures and tables, and why those that cannot be cannot.
Blocks stages_section(const OperationResults& results);

/// The governing check of each region, stage by stage; then those of every stage in full, folded. Empty without any.
Blocks stage_checks_section(const OperationResults& results);

/// "Stage 7 (head on the bed) cannot be: no equilibrium at the head: the cable is too short. ..."
std::string failure_words(const OperationResults& results, std::size_t stage);

}  // namespace overbend
