/// Checks of mooring lines, anchors and standalone lines: tension times a safety factor over breaking load or holding
/// capacity.
#pragma once

#include <vector>

#include "model/description/description.h"
#include "results/check_results.h"
#include "results/dynamic_results.h"
#include "results/line_results.h"
#include "results/mooring_results.h"

namespace overbend {

/// Analysis of the tension of a line: the safety factor covers the effects it omits.
enum class TensionAnalysis { quasi_static, dynamic };

/// Safety factor and its source, as shown in a remark.
struct SafetyFactor {
  double value = 1.0;
  std::string source;  ///< "API RP 2SK, intact, quasi-static"
};

/// Returns the required breaking load of a mooring line over its tension: from checks.safety_factors, else API RP 2SK
/// (2005): 2.0 quasi-static and 1.67 dynamic for the intact mooring, 1.43 and 1.25 with one line missing.
SafetyFactor mooring_safety_factor(const SafetyFactors& factors, bool damaged, TensionAnalysis analysis);

/// Returns the required holding capacity of an anchor over its load: from checks.safety_factors, else 1.5, and 1.0 with
/// one line missing (drag anchors; recalled from API RP 2SK, not compared with a public text).
SafetyFactor anchor_safety_factor(const SafetyFactors& factors, bool damaged);

/// Returns the factor of a wire that holds the pipe: checks.safety_factors.cable, else 3.
SafetyFactor cable_safety_factor(const SafetyFactors& factors);

/// Returns rows for the static state, the stages of an operation, and a run if there was one (`dynamics` may be null):
/// the line with the maximum utilisation of breaking load and of working load, and the anchor with the maximum
/// utilisation.
std::vector<CheckRow> mooring_rows(const Description& description, const MooringResults& rest,
                                   const DynamicResults* dynamics);

/// Returns rows for standalone lines: the line with the maximum utilisation; wires on other lines without a breaking
/// load by name.
std::vector<CheckRow> line_rows(const Description& description, const std::vector<LineResult>& lines,
                                const std::vector<LineDynamics>* in_time);

}  // namespace overbend
