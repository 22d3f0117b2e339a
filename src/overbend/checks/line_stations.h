/// Lines that are pipe as the checks of a laid pipe take them.
#pragma once

#include <vector>

#include "checks/check_station.h"
#include "results/lift_results.h"

namespace overbend {

/// Stations of the static state, a set for every line with pipe in it: nodes of pipe, both sides where tension or
/// section jumps. In a current, whose part of the load effects is not found apart, all of them have the larger of the
/// functional and the environmental load factor.
std::vector<CheckStations> line_stations(const Model& model, const LiftResults& lift);

/// The same over a run from that state, with the largest moment and the tension that is worse of each node, which need
/// not be of one instant: on the safe side. What is more than in the static state is an environmental load effect.
/// Without stations where the run did not keep moments.
std::vector<CheckStations> line_stations_in_time(const Model& model, const StaticResults& statics,
                                                 const std::vector<LineDynamics>& run);

/// Whether the load factors of lines are raised for the current.
bool raises_factors_for_current(const Description& description);

}  // namespace overbend
