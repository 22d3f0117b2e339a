/// The calculation sheets of the code checks in a report.
#pragma once

#include "report/page/blocks.h"
#include "results/check_results.h"

namespace overbend {

/// For the most used row of each check: formulas with symbols, the numbers put in, values, clauses and how far each is
/// confirmed. Empty without sheets.
Blocks calculation_sheet_section(const CheckTable& table);

/// "Basis of the checks: see the calculation sheet."
extern const char* const kBasisOfChecks;

}  // namespace overbend
