/// The section on a floating hull: damping of its slow motions, steady loads, and how well its memory of radiated waves
/// represents the hydrodynamic file.
#pragma once

#include "report/page/blocks.h"
#include "results/hull_results.h"

namespace overbend {

Blocks hull_section(const HullResults& hull);

}  // namespace overbend
