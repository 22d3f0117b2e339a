/// Warnings of a time-domain simulation: results.findings.
#pragma once

#include "results/dynamic_results.h"

namespace overbend {

/// Warns of compression anywhere at any time. Appended to `results.findings`.
void warn_of_slack(const StaticResults& statics, DynamicResults& results);

/// A station of linear elastic steel and its maximum von Mises stress [Pa].
struct YieldingStation {
  double s = 0.0;  ///< Arc length from the anchor [m].
  double von_mises = 0.0, yield_stress = 0.0;
  double share() const { return von_mises / yield_stress; }
};

/// Warns of stress beyond yield at the station with the highest ratio, with its time if known. Appended to
/// `results.findings`.
void warn_of_yield(const StaticResults& statics, const YieldingStation& worst, DynamicResults& results);

/// Warns of boxes that the pipe left over their sides, from `results.supports`: one finding per side. Appended to
/// `results.findings`.
void warn_of_left_boxes(DynamicResults& results);

/// Warns that the pipe moved by `distance` [m] from its static position at arc length `s` [m] before any excitation.
/// Appended to `results.findings`.
void warn_of_departure(const StaticResults& statics, double distance, double s, double time, DynamicResults& results);

}  // namespace overbend
