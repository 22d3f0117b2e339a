/// Reads a measured elevation of the sea surface at a point.
#pragma once

#include <optional>
#include <string>

#include "base/diagnostics.h"
#include "model/description/waves_description.h"

namespace overbend {

/// Reads CSV text with the columns time_s and elevation_m, in even steps; t = 0 is the first row. Lines that begin with
/// # are skipped. The mean is subtracted. Errors name the line, and nothing is returned: fewer than 20 rows, uneven
/// steps, missing values, no variation.
std::optional<ElevationRecord> read_elevation_text(const std::string& text, const std::string& path,
                                                   Diagnostics& diagnostics);

}  // namespace overbend
