/// The stages of an operation on the line: figures, tables, checks. HTML.
#pragma once

#include <string>

#include "results/operation_results.h"

namespace overbend {

/// All stages in figures and tables, and why those that cannot be cannot; `number` counts the figures.
std::string stages_section(const OperationResults& results, int& number);

/// The governing check of each region, stage by stage; then those of every stage in full, folded. Empty without any.
std::string stage_checks_section(const OperationResults& results);

/// "Stage 7 (head on the bed) cannot be: no equilibrium at the head: the cable is too short. ..." Plain text.
std::string failure_words(const OperationResults& results, std::size_t stage);

}  // namespace overbend
