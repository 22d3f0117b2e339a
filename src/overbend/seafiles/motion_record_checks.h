/// Checks of a recorded motion: impossible values and artefacts of recorders.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "base/diagnostics.h"
#include "model/description/motion_history.h"

namespace overbend {

/// A recorded motion history.
struct MotionRecord {
  MotionHistory history;
  std::vector<int> lines;       ///< Line number in the file, by row.
  std::array<bool, 6> given{};  ///< True for the degrees of freedom that have a column.
  bool compass = false;         ///< True if yaw was written from 0 to 360 deg, like a compass heading.
};

/// Column names of the degrees of freedom in the file: "surge_m" to "yaw_deg".
extern const std::array<const char*, 6> kMotionColumns;

/// Reports values that no floating vessel can have as errors (missing values written as 999 or 1e20, map coordinates,
/// centimetres). Angles may cover the full circle.
void check_motion_values(const MotionRecord& record, Diagnostics& diagnostics);

/// Makes roll, pitch and yaw continuous where they wrap around, with a mean within half a turn of zero.
void unwrap_angles(MotionRecord& record);

/// Warns about doubtful data: jumps, runs of equal values, a mean away from zero, angles in the wrong unit, a time step
/// that varies, has gaps or is too long for the motion. `heading` is vessel.heading [rad], clockwise from north.
void check_motion_record(const MotionRecord& record, double heading, Diagnostics& diagnostics);

}  // namespace overbend
