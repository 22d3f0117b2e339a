/// Contents of a bathymetry file in its own coordinates, and what its readers share.
#pragma once

#include <optional>
#include <string>

#include "base/diagnostics.h"
#include "model/description/seabed_description.h"

namespace overbend {

/// Largest number of cells of a grid.
inline constexpr double kMaxBathymetryCells = 4'000'000;

/// End of the notice on land that is left out.
inline constexpr const char* kLand = "of land; the seabed there continues from the nearest depths";

enum class MapUnit {
  unstated,  ///< Metres, or degrees if the origin of the model is given in degrees.
  metres,
  degrees,
};

/// Depths in the coordinates of their file: east and north, or longitude and latitude [deg].
struct BathymetryFile {
  Bathymetry depths;
  MapUnit unit = MapUnit::unstated;
};

/// Reports errors and notices of a file.
class BathymetryMessages {
 public:
  BathymetryMessages(const std::string& path, Diagnostics& diagnostics) : path_(path), diagnostics_(diagnostics) {}
  void error(int line, std::string key, std::string found, std::string expected, std::string hint = {});
  void notice(std::string message);
  /// Reports what was left out, nothing if the count is 0: "left out: 8 cells without data".
  void left_out(std::size_t count, const std::string& noun, const std::string& rest);
  bool good() const { return good_; }
  const std::string& path() const { return path_; }
  Diagnostics& diagnostics() { return diagnostics_; }

 private:
  const std::string& path_;
  Diagnostics& diagnostics_;
  bool good_ = true;
};

/// Accepts land above the water (negative depth) but rejects values that stand for missing data.
void check_bathymetry_depth(double depth, int line, BathymetryMessages& messages);

/// Reads a table of soundings: three columns of east, north and depth or height, by blanks, commas, semicolons or tabs,
/// with or without a header. `values`, or the header, or the sign of all values states whether they are depths or
/// heights; values of both signs without a statement are an error. Land is left out where heights are given.
std::optional<BathymetryFile> read_soundings(const std::string& text, std::optional<BathymetryValues> values,
                                             BathymetryMessages& messages);

/// Reads an ESRI ASCII grid: depths, or heights if most values are negative and `values` is not given. Cells without
/// data are left out, and the others are scattered points then.
std::optional<BathymetryFile> read_esri_grid(const std::string& text, std::optional<BathymetryValues> values,
                                             BathymetryMessages& messages);

/// Reads a netCDF grid, classic or netCDF-4: coordinates lat and lon, or y and x, and elevation, depth or z. Land and
/// cells without data are left out.
std::optional<BathymetryFile> read_netcdf_grid(std::optional<BathymetryValues> values, BathymetryMessages& messages);

}  // namespace overbend
