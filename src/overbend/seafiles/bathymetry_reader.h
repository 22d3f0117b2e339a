/// Reads bathymetry: water depths over an area.
#pragma once

#include <optional>
#include <string>

#include "base/diagnostics.h"
#include "model/description/seabed_description.h"

namespace overbend {

/// Reads CSV text: a header `east,north,depth` (with or without `_m`), then a row per point in m, in any order. Points
/// at all crossings of a set of eastings and northings form a regular grid; any others are scattered. Every error is
/// reported with its line.
std::optional<Bathymetry> read_depth_table(const std::string& text, const std::string& path, Diagnostics& diagnostics);

/// Reads an ESRI ASCII grid: depths, or heights if most values are negative. If cells lack data, the remaining points
/// are scattered.
std::optional<Bathymetry> read_ascii_grid(const std::string& text, const std::string& path, Diagnostics& diagnostics);

/// Reads a file: an ESRI grid if its name ends in .asc, a CSV table otherwise. A GeoTIFF is rejected with a hint.
std::optional<Bathymetry> read_bathymetry(const std::string& path, Diagnostics& diagnostics);

}  // namespace overbend
