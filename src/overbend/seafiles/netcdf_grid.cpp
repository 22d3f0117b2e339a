/// NetCDF grids of elevations or depths, such as those of GEBCO.
#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "base/ranges.h"
#include "base/units.h"
#include "seafiles/bathymetry_file.h"
#include "seafiles/netcdf_arrays.h"

namespace overbend {
namespace {

/// A variable and the name under which it was found.
struct NamedArray {
  std::string name;
  NetcdfArray array;
};

std::optional<NamedArray> find_array(const NetcdfFile& file, const std::vector<std::string>& names) {
  for (const std::string& name : names) {
    if (std::optional<NetcdfArray> array = file.numbers(name)) return NamedArray{name, std::move(*array)};
  }
  return std::nullopt;
}

/// Coordinates and values of a grid.
struct Grid {
  NamedArray east, north, values;
  bool transposed = false;  ///< True if north varies fastest.
};

bool is_axis(const NetcdfArray& array) {
  return array.sizes.size() == 1 && array.sizes[0] >= 2 &&
         ranges::all_of(array.values, [](double value) { return std::isfinite(value); });
}

std::optional<Grid> find_grid(const NetcdfFile& file, BathymetryMessages& messages) {
  std::optional<NamedArray> east = find_array(file, {"lon", "longitude", "x", "easting"});
  std::optional<NamedArray> north = find_array(file, {"lat", "latitude", "y", "northing"});
  std::optional<NamedArray> values = find_array(file, {"elevation", "depth", "z", "Band1", "height", "altitude"});
  if (!east || !north || !values) {
    messages.error(0, "",
                   "a netCDF file without " + std::string(!east    ? "lon or x"
                                                          : !north ? "lat or y"
                                                                   : "elevation, depth or z"),
                   "the coordinates lat and lon (or y and x) and elevation, depth or z");
    return std::nullopt;
  }
  if (!is_axis(east->array) || !is_axis(north->array)) {
    const NamedArray& axis = is_axis(east->array) ? *north : *east;
    messages.error(0, axis.name, "a variable that is not an axis of two or more numbers",
                   "coordinates of a regular grid");
    return std::nullopt;
  }
  const std::string &x = east->array.dimensions[0], &y = north->array.dimensions[0];
  const std::vector<std::string>& order = values->array.dimensions;
  const bool transposed = order == std::vector<std::string>{x, y};
  if (!transposed && order != std::vector<std::string>{y, x}) {
    messages.error(0, values->name, "a variable over " + std::to_string(order.size()) + " dimensions",
                   "values over " + north->name + " and " + east->name);
    return std::nullopt;
  }
  if (static_cast<double>(values->array.values.size()) > kMaxBathymetryCells) {
    messages.error(0, values->name, std::to_string(values->array.values.size()) + " cells", "at most four million",
                   "cut the grid to the area of the lay");
    return std::nullopt;
  }
  return Grid{std::move(*east), std::move(*north), std::move(*values), transposed};
}

/// Returns true for heights, false for depths: as stated, by the name of the variable, or by the sign of all values.
std::optional<bool> are_heights(const Grid& grid, std::optional<BathymetryValues> stated,
                                BathymetryMessages& messages) {
  if (stated) return *stated == BathymetryValues::elevation;
  if (grid.values.name == "depth") return false;
  if (grid.values.name == "elevation" || grid.values.name == "height" || grid.values.name == "altitude") return true;
  const bool below = ranges::any_of(grid.values.array.values, [](double value) { return value < 0.0; });
  const bool above = ranges::any_of(grid.values.array.values, [](double value) { return value > 0.0; });
  if (!below || !above) return below;
  messages.error(0, grid.values.name, "values of both signs", "depths or heights",
                 "environment.seabed.bathymetry_values: elevation or depth states which");
  return std::nullopt;
}

/// Adds the cells below the water; counts those left out.
void add_cells(const Grid& grid, bool heights, BathymetryFile& file, BathymetryMessages& messages) {
  const std::size_t columns = grid.east.array.values.size(), rows = grid.north.array.values.size();
  std::size_t land = 0, missing = 0;
  for (std::size_t row = 0; row < rows; ++row) {
    for (std::size_t column = 0; column < columns; ++column) {
      const double value = grid.values.array.values[grid.transposed ? column * rows + row : row * columns + column];
      const double depth = heights ? -value : value;
      missing += std::isnan(value) ? 1 : 0;
      land += depth < 0.0 ? 1 : 0;
      if (std::isnan(value) || depth < 0.0) continue;
      if (messages.good()) check_bathymetry_depth(depth, 0, messages);
      file.depths.east.push_back(grid.east.array.values[column]);
      file.depths.north.push_back(grid.north.array.values[row]);
      file.depths.depth.push_back(depth);
    }
  }
  messages.left_out(missing, "cell", "without data");
  messages.left_out(land, "cell", kLand);
}

}  // namespace

std::optional<BathymetryFile> read_netcdf_grid(std::optional<BathymetryValues> values, BathymetryMessages& messages) {
  try {
    const NetcdfFile contents(messages.path());
    const std::optional<Grid> grid = find_grid(contents, messages);
    const std::optional<bool> heights = grid ? are_heights(*grid, values, messages) : std::nullopt;
    if (!heights) return std::nullopt;
    BathymetryFile file;
    const bool degrees = grid->east.name.starts_with("lon") && grid->north.name.starts_with("lat");
    file.unit = degrees ? MapUnit::degrees : MapUnit::unstated;
    add_cells(*grid, *heights, file, messages);
    if (*heights) messages.notice("its values are heights, negative below the mean water level");
    return file;
  } catch (const std::runtime_error& error) {
    messages.error(0, "", error.what(), "a netCDF grid of elevations or depths");
    return std::nullopt;
  }
}

}  // namespace overbend
