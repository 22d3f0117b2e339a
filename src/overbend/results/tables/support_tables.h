/// Tables of a lay at rest: the pipe at its supports, the roller boxes, their rollers.
#pragma once

#include "results/static_results.h"
#include "results/tables/table.h"

namespace overbend {

/// The pipe at tensioner, supports, sagbend maximum, touchdown and anchor, in the layout of lay analyses.
Table station_summary(const StaticResults& results);

/// Place, reaction and separation of every box.
Table roller_boxes(const StaticResults& results);

/// Every roller by itself; those that carry are marked.
Table single_rollers(const StaticResults& results);

}  // namespace overbend
