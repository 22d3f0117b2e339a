/// Reads bathymetry: water depths over an area.
#pragma once

#include <optional>
#include <string>

#include "base/diagnostics.h"
#include "model/description/seabed_description.h"

namespace overbend {

/// Position of the model in the file and meaning of its values, from the keys of the model.
struct BathymetrySettings {
  MapOrigin origin = {};
  std::optional<BathymetryValues> values = {};
};

/// Reads a table of soundings (seafiles/bathymetry_file.h) and returns it in the frame of the model. Points at all
/// crossings of a set of eastings and northings form a regular grid; any others are scattered. Every error is reported
/// with its line, and a notice for every conversion.
std::optional<Bathymetry> read_depth_table(const std::string& text, const std::string& path, Diagnostics& diagnostics,
                                           const BathymetrySettings& settings = {});

/// The same of an ESRI ASCII grid.
std::optional<Bathymetry> read_ascii_grid(const std::string& text, const std::string& path, Diagnostics& diagnostics,
                                          const BathymetrySettings& settings = {});

/// Reads a file, recognised by its content: an ESRI grid, a netCDF grid, or a table of soundings. A GeoTIFF is rejected
/// with a hint.
std::optional<Bathymetry> read_bathymetry(const std::string& path, Diagnostics& diagnostics,
                                          const BathymetrySettings& settings = {});

}  // namespace overbend
