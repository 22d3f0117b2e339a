/// Section on a floating hull: damping of its low-frequency motions, steady loads, and the accuracy of its radiation
/// memory compared with the hydrodynamic file.
#pragma once

#include "report/page/blocks.h"
#include "results/hull_results.h"

namespace overbend {

/// Returns the section.
Blocks hull_section(const HullResults& hull);

}  // namespace overbend
