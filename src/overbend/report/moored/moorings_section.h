/// Sections on the static results of mooring lines: texts and tables. Each is empty without content.
#pragma once

#include "report/page/blocks.h"
#include "results/mooring_results.h"

namespace overbend {

/// Returns tiles, plan, table of lines, profiles and the equilibrium of the hull.
Blocks moorings_section(const MooringResults& results);

/// Returns the stages of the operation; winch operations and pipe results of a pull-ahead; anchor moves
/// (operation_section.cpp).
Blocks operation_section(const MooringResults& results);

}  // namespace overbend
