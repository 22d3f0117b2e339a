/// Reads water depths along a route.
#pragma once

#include <string>
#include <vector>

#include "base/diagnostics.h"
#include "model/description/lay_table_description.h"

namespace overbend {

/// Reads a table: a header of distance or kp and depth or elevation, with the unit of each, `kp_km,depth_m` or
/// "KP (km); Depth (m)", then a row per point with increasing distance. Separators and decimal commas are recognised
/// (seafiles/table_layout.h); other columns are not used. `path` names the text in messages; every error is reported
/// with its line, conversions give notices. Returns an empty list after an error.
std::vector<RouteDepth> read_route_depths_text(const std::string& text, const std::string& path,
                                               Diagnostics& diagnostics);

/// The same from a file.
std::vector<RouteDepth> read_route_depths(const std::string& path, Diagnostics& diagnostics);

}  // namespace overbend
