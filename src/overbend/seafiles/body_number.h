/// Selection of one body in a file of several.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "seafiles/hull_file_error.h"

namespace overbend {

/// Returns the index, from 0, of the body with the number `wanted` (from 1), or of the only one. `names` are those of
/// the file, in order; they may be empty texts. Throws HullFileError.
inline std::size_t find_body(const std::optional<int>& wanted, const std::vector<std::string>& names) {
  const std::size_t count = names.size();
  if (count == 0) throw HullFileError("no body", "hydrodynamic data of a hull");
  if (!wanted && count == 1) return 0;
  if (wanted && *wanted >= 1 && static_cast<std::size_t>(*wanted) <= count) {
    return static_cast<std::size_t>(*wanted) - 1;
  }
  std::string list;
  for (std::size_t k = 0; k < count && k < 10; ++k) {
    list += (k == 0 ? "" : ", ") + std::to_string(k + 1) + (names[k].empty() ? "" : " (" + names[k] + ")");
  }
  throw HullFileError(wanted ? "no body " + std::to_string(*wanted) : std::to_string(count) + " bodies",
                      "one of the bodies " + list, "select with vessel.motion.coupled.convention.body");
}

}  // namespace overbend
