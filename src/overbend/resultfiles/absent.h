/// Values that may be absent. Inside the program such a value is not a number; in tables of text it is an empty cell,
/// in JSON null, in HDF5 NaN with the attribute _FillValue, and diagrams have a gap.
#pragma once

#include <string_view>

namespace overbend {

/// Whether a field or a history may have no value: distances to a roller, which a pipe that does not pass it has none
/// of. `name` as in ResultField or HistoryColumn.
inline bool may_be_absent(std::string_view name) {
  const std::string_view last = name.substr(name.rfind('/') + 1);
  return last.find("separation") != std::string_view::npos || last.starts_with("stinger_tip_clearance");
}

}  // namespace overbend
