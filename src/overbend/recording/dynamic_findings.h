/// What in a time-domain run calls for a second look, in words: results.findings.
#pragma once

#include "results/dynamic_results.h"

namespace overbend {

/// Compression anywhere at any time. Appended to `results.findings`.
void warn_of_slack(const StaticResults& statics, DynamicResults& results);

/// A place of linear elastic steel and the largest von Mises stress that it saw [Pa].
struct YieldingPlace {
  double s = 0.0;  ///< Arc length from the anchor [m].
  double von_mises = 0.0, yield_stress = 0.0;
  double share() const { return von_mises / yield_stress; }
};

/// Stress beyond yield, at the place where it is furthest beyond; the time is told where it is known. Appended to
/// `results.findings`.
void warn_of_yield(const StaticResults& statics, const YieldingPlace& worst, DynamicResults& results);

/// Boxes that the pipe left over their ends, by `results.supports`: a line for each side. Appended to
/// `results.findings`.
void warn_of_left_boxes(DynamicResults& results);

/// That the pipe went `distance` [m] from its static place at `s` [m] before anything moved it. Appended to
/// `results.findings`.
void warn_of_departure(const StaticResults& statics, double distance, double s, double time, DynamicResults& results);

}  // namespace overbend
