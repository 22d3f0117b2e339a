/// Checks of mooring lines, anchors and lines by themselves: tension times a safety factor over breaking load or
/// holding power.
#pragma once

#include <vector>

#include "model/description/description.h"
#include "results/check_results.h"
#include "results/dynamic_results.h"
#include "results/line_results.h"
#include "results/mooring_results.h"

namespace overbend {

/// How the tension of a line was found: a safety factor covers what the analysis leaves out.
enum class TensionAnalysis { quasi_static, dynamic };

/// A safety factor and where it is from, as a remark has it.
struct SafetyFactor {
  double value = 1.0;
  std::string source;  ///< "API RP 2SK, intact, quasi-static"
};

/// Required breaking load of a mooring line over its tension: of checks.safety_factors, else of API RP 2SK (2005):
/// 2.0 quasi-static and 1.67 dynamic where all lines are there, 1.43 and 1.25 where one is missing.
SafetyFactor mooring_safety_factor(const SafetyFactors& given, bool damaged, TensionAnalysis analysis);

/// Required holding power of an anchor over its load: of checks.safety_factors, else 1.5, and 1.0 where a line is
/// missing (drag anchors; recalled from API RP 2SK, not compared with a public text).
SafetyFactor anchor_safety_factor(const SafetyFactors& given, bool damaged);

/// Of a wire that holds the pipe: of checks.safety_factors.cable, else 3.
SafetyFactor cable_safety_factor(const SafetyFactors& given);

/// Of the rest, of the stages of an operation, and of a run in time where there was one (`dynamics` may be null): the
/// line used most, by breaking load and by working load, and the anchor used most.
std::vector<CheckRow> mooring_rows(const Description& description, const MooringResults& rest,
                                   const DynamicResults* dynamics);

/// Of lines by themselves: the line used most; wires on other lines without a breaking load by name.
std::vector<CheckRow> line_rows(const Description& description, const std::vector<LineResult>& lines,
                                const std::vector<LineDynamics>* in_time);

}  // namespace overbend
