/// The sections on mooring lines at rest: words and tables. Each is empty where there is nothing to say.
#pragma once

#include "report/page/blocks.h"
#include "results/mooring_results.h"

namespace overbend {

/// Tiles, plan, table of lines, profiles and where the hull lies.
Blocks moorings_section(const MooringResults& results);

/// The stages of the operation; what winches do and the pipe has in a pull-ahead; where anchors go
/// (operation_section.cpp).
Blocks operation_section(const MooringResults& results);

}  // namespace overbend
