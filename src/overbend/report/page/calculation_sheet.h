/// The calculation sheets of the code checks in a report.
#pragma once

#include "report/page/blocks.h"
#include "results/check_results.h"

namespace overbend {

/// Returns, for the row of each check with the maximum utilisation: formulas with symbols, with numbers, values,
/// clauses and their confirmation. Empty without sheets.
Blocks calculation_sheet_section(const CheckTable& table);

/// "Basis of the checks: see the calculation sheet."
extern const char* const kBasisOfChecks;

}  // namespace overbend
