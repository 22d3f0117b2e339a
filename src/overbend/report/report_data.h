/// What the report's figures draw.
#pragma once

#include <string>

#include "results/static_results.h"

namespace overbend {

/// JSON: stations as columns, boxes with rows and rollers, vessel, places and extremes; SI, points as (astern of the
/// stern shoe, to port, above the water). Long lines are thinned where they are straight, never at an extreme.
std::string report_data(const StaticResults& results);

}  // namespace overbend
