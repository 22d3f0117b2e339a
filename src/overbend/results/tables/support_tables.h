/// Tables of a static lay: the pipe at its supports, the roller boxes, their rollers.
#pragma once

#include "results/static_results.h"
#include "results/tables/table.h"

namespace overbend {

/// Returns the pipe at tensioner, supports, sagbend maximum, touchdown and anchor, in the usual layout of lay analyses.
Table station_summary(const StaticResults& results);

/// Returns position, reaction and separation of every box.
Table roller_boxes(const StaticResults& results);

/// Returns every roller; rollers in contact are marked.
Table single_rollers(const StaticResults& results);

}  // namespace overbend
