/// Checks of a recorded motion: values that a vessel cannot have, and what recorders leave behind.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "base/diagnostics.h"
#include "model/description/motion_history.h"

namespace overbend {

/// A record as it was read.
struct MotionRecord {
  MotionHistory history;
  std::vector<int> lines;       ///< Line of the file of each row.
  std::array<bool, 6> given{};  ///< Freedoms that have a column.
  bool compass = false;         ///< Yaw was written from 0 to 360 deg, as a compass has it.
};

/// Columns of the freedoms in the file: "surge_m" to "yaw_deg".
extern const std::array<const char*, 6> kMotionColumns;

/// Reports as errors what can only be wrong: values that no floating vessel has (missing values written as 999 or 1e20,
/// map coordinates, centimetres). Angles may go round the circle.
void check_motion_values(const MotionRecord& record, Diagnostics& diagnostics);

/// Makes roll, pitch and yaw continuous where they pass from one end of the circle to the other, with a mean within
/// half a turn of zero.
void unwrap_angles(MotionRecord& record);

/// Reports as warnings what is doubtful: leaps, runs of equal values, a mean away from zero, angles in the wrong unit,
/// a time step that changes, leaves holes or is too long for the motion. `heading` is vessel.heading [rad], clockwise
/// from north.
void check_motion_record(const MotionRecord& record, double heading, Diagnostics& diagnostics);

}  // namespace overbend
