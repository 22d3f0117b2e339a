/// Reads water depths along a route.
#pragma once

#include <string>
#include <vector>

#include "base/diagnostics.h"
#include "model/description/lay_table_description.h"

namespace overbend {

/// Reads CSV text: a header `distance_m,depth_m` or `kp_km,depth_m`, then a row per point with increasing distance;
/// lines that begin with # are skipped. `path` names the text in messages; every error is reported with its line.
/// Returns an empty list after an error.
std::vector<RouteDepth> read_route_depths_text(const std::string& text, const std::string& path,
                                               Diagnostics& diagnostics);

/// The same from a file.
std::vector<RouteDepth> read_route_depths(const std::string& path, Diagnostics& diagnostics);

}  // namespace overbend
