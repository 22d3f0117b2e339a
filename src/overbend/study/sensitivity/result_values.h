/// Scalar results of a static analysis, with their names in summary.json.
#pragma once

#include <string>
#include <vector>

#include "results/static_results.h"

namespace overbend {

struct ResultValue {
  std::string name;  ///< "static.supports[stinger 7].reaction"
  std::string text;  ///< "Reaction of stinger 7"
  std::string unit;  ///< SI.
  double value = 0.0;
  bool key = false;  ///< One of the main results.
};

/// Returns tensions, positions, extremes of the regions, reactions and separations of the supports, and utilisations of
/// the evaluated checks.
std::vector<ResultValue> result_values(const StaticResults& results);

}  // namespace overbend
