/// Reads a measured elevation of the sea surface at a point.
#pragma once

#include <optional>
#include <string>

#include "base/diagnostics.h"
#include "model/description/waves_description.h"

namespace overbend {

/// Reads a table (seafiles/table_layout.h) with a column of times, in any form that seafiles/record_clock.h takes, and
/// one of elevations with a unit of length, such as time_s,elevation_m, in even steps; t = 0 is the first row. The mean
/// is subtracted. Errors name the line, and nothing is returned: fewer than 20 rows, uneven steps, missing values, no
/// variation.
std::optional<ElevationRecord> read_elevation_text(const std::string& text, const std::string& path,
                                                   Diagnostics& diagnostics);

}  // namespace overbend
