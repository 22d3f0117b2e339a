/// Names of histories.
#pragma once

#include <string>
#include <string_view>

namespace overbend {

/// The quantity that a history holds: one of the largest or smallest values since the row before is that of the
/// quantity itself, seen without gaps. "top_tension_peak" and "top_tension_low" hold "top_tension".
inline std::string quantity_of(std::string_view history) {
  for (const std::string_view end : {"_peak", "_low"}) {
    if (history.ends_with(end)) return std::string(history.substr(0, history.size() - end.size()));
  }
  return std::string(history);
}

}  // namespace overbend
