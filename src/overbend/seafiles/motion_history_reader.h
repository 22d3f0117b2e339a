/// Reads a motion history of the vessel from a table.
#pragma once

#include <map>
#include <optional>
#include <string>

#include "base/diagnostics.h"
#include "model/description/motion_history.h"

namespace overbend {

/// Meaning of columns by their title in the file, with or without its unit: "time", "heave", "roll_rad", "surge [cm]",
/// "time (Unix, s)", or kUnusedColumn.
using MotionColumns = std::map<std::string, std::string>;
inline constexpr const char* kUnusedColumn = "unused";

/// Reads a table with a column of time (seafiles/record_clock.h) and any of surge, sway, heave, roll, pitch and yaw, in
/// any order; degrees of freedom without a column are zero. Units are in the titles ("heave_m", "Heave [m]"), in a line
/// below them or in `columns`, and must be stated; separators, decimal commas and quotes are recognised
/// (seafiles/table_layout.h). Times increase strictly; at least two rows are required. Angles that wrap at 360 deg are
/// made continuous. On error, reports file and line to `diagnostics` and returns nothing; doubtful data give warnings
/// (seafiles/motion_record_checks.h), conversions give notices. `heading` is vessel.heading [rad].
std::optional<MotionHistory> read_motion_history(const std::string& file, double heading, Diagnostics& diagnostics,
                                                 const MotionColumns& columns = {});

}  // namespace overbend
