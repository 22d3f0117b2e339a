/// How the pipe lies on its route, from an equilibrium.
#pragma once

#include "results/static_results.h"
#include "statics/equations/static_system.h"

namespace overbend {

/// Fills `results.route` from touchdown, tension and sums found before. Nothing where the route is straight and no side
/// load acts. Least radius of a curve that friction holds: R = H / (mu w), balance of the string's pull H/R with mu w.
void recover_route(StaticResults& results, const StaticSystem& system, const LineState& state);

}  // namespace overbend
