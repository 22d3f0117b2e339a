/// Tables of a vessel and its mooring lines, static and over time.
#pragma once

#include <string>
#include <vector>

#include "results/dynamic_results.h"
#include "results/mooring_results.h"
#include "results/tables/table.h"

namespace overbend {

/// Returns the static results of the lines; rows of parted and slack lines are marked soft, those over a breaking load
/// or a holding power over.
Table moorings_at_rest(const std::vector<MooringLineResult>& lines);

/// Returns the reference of the shifts along and across: "route", or "hull" without a pipe, which has no route.
const char* course(const DynamicResults& results);

/// Returns the motion of the vessel with its low-frequency and wave-frequency parts. `course`: reference of along and
/// across.
Table vessel_motions(const VesselDynamics& vessel, const std::string& course);

/// Returns the tension at the fairleads with its low-frequency and wave-frequency parts.
Table fairlead_tensions(const std::vector<MooringLineDynamics>& lines);

/// Returns the utilisation of the lines over a run.
Table moorings_over_time(const std::vector<MooringLineDynamics>& lines);

/// Returns the thrust of dynamic positioning: ahead, to port, bow to port.
Table thrust_over_time(const std::vector<ThrustDynamics>& thrust);

/// Returns the events of the lines, in the order of time.
Table mooring_events(const std::vector<MooringLineDynamics>& lines);

}  // namespace overbend
