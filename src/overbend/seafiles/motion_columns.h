/// Columns of a recorded motion: quantity and unit of each, from titles, a line of units and the keys of the model.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/diagnostics.h"
#include "seafiles/motion_history_reader.h"
#include "seafiles/table_layout.h"

namespace overbend {

/// A column of a record.
struct MotionColumn {
  enum class Quantity { unused, time, freedom };
  Quantity quantity = Quantity::unused;
  std::size_t freedom = 0;  ///< 0 to 5, surge to yaw.
  double factor = 1.0;      ///< To m or rad; not of time.
  std::string unit;         ///< Unit of time; empty if it is not stated.
  bool is_unix = false;     ///< True if the title says that times are Unix times.
  std::string label;        ///< Name with unit for messages: "heave_m".
};

/// Returns the columns of the table, which has a header. Reports unknown and repeated columns, missing and
/// contradictory units, and returns nothing then.
std::optional<std::vector<MotionColumn>> find_motion_columns(const ExportedTable& table, const MotionColumns& keys,
                                                             const std::string& path, Diagnostics& diagnostics);

}  // namespace overbend
