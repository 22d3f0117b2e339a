/// Names of histories.
#pragma once

#include <string>
#include <string_view>

namespace overbend {

/// Returns the quantity of a history. Maxima and minima since the preceding row belong to the quantity itself:
/// "top_tension_peak" and "top_tension_low" hold "top_tension".
inline std::string history_quantity(std::string_view history) {
  for (const std::string_view end : {"_peak", "_low"}) {
    if (history.ends_with(end)) return std::string(history.substr(0, history.size() - end.size()));
  }
  return std::string(history);
}

}  // namespace overbend
