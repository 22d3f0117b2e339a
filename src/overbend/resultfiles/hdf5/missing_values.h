/// Missing values. In memory a missing value is NaN; in text tables an empty cell, in JSON null, in HDF5 NaN with the
/// attribute _FillValue; diagrams have a gap.
#pragma once

#include <string_view>

namespace overbend {

/// Returns true if a field or a history may have missing values: the distance to a roller while the pipe does not pass
/// it, and the fitted circle of collinear boxes. `name` as in ResultField or HistoryColumn.
inline bool may_be_missing(std::string_view name) {
  const std::string_view last = name.substr(name.rfind('/') + 1);
  return last.find("separation") != std::string_view::npos || last.starts_with("stinger_tip_clearance") ||
         last.ends_with("fitted_radius");
}

/// Returns the same for a dataset of results.h5. Breaking load, holding power and nearby objects of mooring lines are
/// optional in the model, and most lines do not part; few hulls have dynamic positioning, and it may have no limits.
inline bool may_be_missing_in_file(std::string_view path) {
  if (may_be_missing(path)) return true;
  const std::string_view last = path.substr(path.rfind('/') + 1);
  if (last == "thrust_limit") return true;
  return path.find("/moorings/") != std::string_view::npos &&
         (last.ends_with("utilisation") || last.ends_with("clearance") || last == "parted_at" ||
          last.ends_with("stiffness") || last == "mooring_force" || last == "thrust");
}

}  // namespace overbend
