/// Separations and reactions of rollers, rows and boxes.
#pragma once

#include <string>

#include "results/static_results.h"
#include "statics/equations/static_system.h"

namespace overbend {

/// Last support that carries the pipe, seen from the tensioner.
struct Departure {
  bool carried = false;  ///< True if any support is in contact.
  double s = 0.0;        ///< Arc length of the last contact [m].
  std::string support;
};

/// Fills `results.supports` and returns the departure point; [silva2009] equations 19 to 21. Uses the contacts of the
/// last evaluation.
Departure recover_supports(StaticResults& results, const StaticSystem& system, const LineState& state);

}  // namespace overbend
