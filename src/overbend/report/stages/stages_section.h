/// The stages of an operation on the line: figures, tables, checks.
#pragma once

#include <string>

#include "report/page/blocks.h"
#include "results/operation_results.h"

namespace overbend {

/// Returns all stages in figures and tables, and the reasons why stages are infeasible.
Blocks stages_section(const OperationResults& results);

/// Returns the governing check of each region, stage by stage; then those of every stage in full, collapsed. Empty
/// without any.
Blocks stage_checks_section(const OperationResults& results);

/// "Stage 7 (head on the bed) cannot be: no equilibrium at the head: the cable is too short. ..."
std::string failure_text(const OperationResults& results, std::size_t stage);

}  // namespace overbend
