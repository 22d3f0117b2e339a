/// Motion history of the vessel from a CSV file.
#pragma once

#include <optional>
#include <string>

#include "base/diagnostics.h"
#include "model/description/motion_history.h"

namespace overbend {

/// Reads columns time_s and any of surge_m, sway_m, heave_m, roll_deg, pitch_deg, yaw_deg, in any order; a freedom
/// without a column stays zero. Times rise strictly; at least two rows. Remarks start with '#'. Angles that pass 360
/// deg are made continuous. Errors go to `diagnostics` with file and line, and nothing is returned; what is doubtful is
/// a warning (seafiles/motion_record_checks.h). `heading` is vessel.heading [rad].
std::optional<MotionHistory> read_motion_history(const std::string& file, double heading, Diagnostics& diagnostics);

}  // namespace overbend
