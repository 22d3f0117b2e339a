/// Separation and reaction of every roller, row and box.
#pragma once

#include <string>

#include "results/static_results.h"
#include "statics/equations/static_system.h"

namespace overbend {

/// The last support that carries the pipe, seen from the tensioner.
struct Departure {
  bool carried = false;  ///< Any support in contact.
  double s = 0.0;        ///< Arc length of the last contact [m].
  std::string support;
};

/// [silva2009] equations 19 to 21; uses the contacts of the last evaluation.
Departure recover_supports(StaticResults& results, const StaticSystem& system, const LineState& state);

}  // namespace overbend
