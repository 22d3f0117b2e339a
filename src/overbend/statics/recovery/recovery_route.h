/// Position of the pipe relative to its route.
#pragma once

#include "results/static_results.h"
#include "statics/equations/static_system.h"

namespace overbend {

/// Fills `results.route` from touchdown, tension and sums found before. Does nothing on a straight route without side
/// load. Minimum radius of a curve held by friction: R = H / (mu w), from the balance of the pull H/R of a string with
/// mu w.
void recover_route(StaticResults& results, const StaticSystem& system, const LineState& state);

}  // namespace overbend
