/// Tables of a vessel and its mooring lines, at rest and over time.
#pragma once

#include <string>
#include <vector>

#include "results/dynamic_results.h"
#include "results/mooring_results.h"
#include "results/tables/table.h"

namespace overbend {

/// Lines at rest: parted and slack ones are soft, those beyond a breaking load or a holding power over.
Table moorings_at_rest(const std::vector<MooringLineResult>& lines);

/// What the shifts ahead and to port are along and across: "route", or "hull" without a pipe, which has no route.
const char* course(const DynamicResults& results);

/// Motion of the vessel with its slow and its wave part. `course`: what it is along and across.
Table vessel_motions(const VesselDynamics& vessel, const std::string& course);

/// Tension at the fairleads with its slow and its wave part.
Table fairlead_tensions(const std::vector<MooringLineDynamics>& lines);

/// What the lines are used over a run.
Table moorings_over_time(const std::vector<MooringLineDynamics>& lines);

/// Of dynamic positioning: ahead, to port, bow to port.
Table thrust_over_time(const std::vector<ThrustDynamics>& thrust);

/// What happened to the lines, in the order of time.
Table mooring_events(const std::vector<MooringLineDynamics>& lines);

}  // namespace overbend
