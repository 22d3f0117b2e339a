/// Reads the depths of an area.
#pragma once

#include <optional>
#include <string>

#include "base/diagnostics.h"
#include "model/description/seabed_description.h"

namespace overbend {

/// From CSV text: a header `east,north,depth` (with or without `_m`), then a row per point in m, in any order. Points
/// on all crossings of some easts and norths make a regular grid, others are scattered. Every error is reported with
/// its line.
std::optional<Bathymetry> read_depth_table(const std::string& text, const std::string& path, Diagnostics& diagnostics);

/// From an ESRI ASCII grid: depths, or heights where none is above 0. Cells without data make the rest scattered.
std::optional<Bathymetry> read_ascii_grid(const std::string& text, const std::string& path, Diagnostics& diagnostics);

/// From a file: a grid where its name ends in .asc, a table otherwise. A GeoTIFF is refused with what to do.
std::optional<Bathymetry> read_bathymetry(const std::string& path, Diagnostics& diagnostics);

}  // namespace overbend
