/// Reads a motion history of the vessel from a CSV file.
#pragma once

#include <optional>
#include <string>

#include "base/diagnostics.h"
#include "model/description/motion_history.h"

namespace overbend {

/// Reads columns time_s and any of surge_m, sway_m, heave_m, roll_deg, pitch_deg, yaw_deg, in any order; degrees of
/// freedom without a column are zero. Times increase strictly; at least two rows are required. Comments start with '#'.
/// Angles that wrap at 360 deg are made continuous. On error, reports file and line to `diagnostics` and returns
/// nothing; doubtful data give warnings (seafiles/motion_record_checks.h). `heading` is vessel.heading [rad].
std::optional<MotionHistory> read_motion_history(const std::string& file, double heading, Diagnostics& diagnostics);

}  // namespace overbend
