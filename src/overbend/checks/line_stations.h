/// Pipe in standalone lines, as stations for the checks of a laid pipe.
#pragma once

#include <vector>

#include "checks/check_station.h"
#include "results/lift_results.h"

namespace overbend {

/// Returns the stations of the static state, a set for every line that contains pipe: nodes of pipe, both sides where
/// tension or section jumps. In a current, whose contribution to the load effects is not separated, all of them have
/// the larger of the functional and the environmental load factor.
std::vector<CheckStations> line_stations(const Model& model, const LiftResults& lift);

/// Returns the stations over a run from that state, with the maximum moment and the governing tension of each node, not
/// necessarily of one instant: conservative. The change from the static state is an environmental load effect. No
/// stations if the run did not store moments.
std::vector<CheckStations> line_stations_in_time(const Model& model, const StaticResults& statics,
                                                 const std::vector<LineDynamics>& run);

/// True if the load factors of lines are raised for the current.
bool raises_factors_for_current(const Description& description);

}  // namespace overbend
