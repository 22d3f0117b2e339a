/// Values that may be absent. Inside the program such a value is not a number; in tables of text it is an empty cell,
/// in JSON null, in HDF5 NaN with the attribute _FillValue, and diagrams have a gap.
#pragma once

#include <string_view>

namespace overbend {

/// Whether a field or a history may have no value: distances to a roller, which a pipe that does not pass it has none
/// of, and the circle through boxes that lie on none. `name` as in ResultField or HistoryColumn.
inline bool may_be_absent(std::string_view name) {
  const std::string_view last = name.substr(name.rfind('/') + 1);
  return last.find("separation") != std::string_view::npos || last.starts_with("stinger_tip_clearance") ||
         last.ends_with("fitted_radius");
}

/// The same of a dataset of results.h5. Mooring lines have no breaking load, holding power or object beside them unless
/// the model says so, and mostly they do not part; few hulls have dynamic positioning,
/// and not all of it has limits.
inline bool may_be_absent_in_file(std::string_view path) {
  if (may_be_absent(path)) return true;
  const std::string_view last = path.substr(path.rfind('/') + 1);
  if (last == "thrust_limit") return true;
  return path.find("/moorings/") != std::string_view::npos &&
         (last.ends_with("utilisation") || last.ends_with("clearance") || last == "parted_at" ||
          last.ends_with("stiffness") || last == "mooring_force" || last == "thrust");
}

}  // namespace overbend
