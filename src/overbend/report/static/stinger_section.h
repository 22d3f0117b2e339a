/// A stinger on hinges in the report.
#pragma once

#include "report/page/blocks.h"
#include "results/static_results.h"

namespace overbend {

/// Angle, hinge force and tanks of each section at rest; empty of a fixed stinger.
Blocks stinger_section(const StaticResults& results);

}  // namespace overbend
