/// The single numbers of a static analysis, by the names that they have in summary.json.
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
  bool key = false;  ///< One of those that are looked at first.
};

/// Tensions, places, extremes of the regions, reactions and separations of the supports, utilisations of the checks
/// that could be made.
std::vector<ResultValue> result_values(const StaticResults& results);

}  // namespace overbend
