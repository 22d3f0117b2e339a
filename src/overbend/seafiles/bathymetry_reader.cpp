#include "seafiles/bathymetry_reader.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <fstream>

#include "base/constants.h"
#include "base/ranges.h"
#include "base/text.h"
#include "base/units.h"
#include "seafiles/bathymetry_file.h"
#include "seafiles/map_projection.h"
#include "seafiles/table_layout.h"
#include "seafiles/text_table.h"

namespace overbend {
namespace {

constexpr double kSamePlace = 1e-6;          ///< Distance below which coordinates are equal [m].
constexpr double kMaxWaterDepth = 12'000.0;  ///< Upper limit of the key environment.water_depth [m].
constexpr double kMaxDistance = 50e3;        ///< Distance from the origin to which degrees are converted [m].
constexpr const char* kNoDataHint = "a value for places without data? Leave these rows out, or name it as NODATA_value";
constexpr const char* kGeographicOrigin = "environment.seabed.bathymetry_origin: {lat, lon}";

/// Returns the sorted distinct coordinates.
std::vector<double> distinct_coordinates(std::vector<double> values) {
  ranges::sort(values);
  std::vector<double> once;
  for (const double value : values) {
    if (once.empty() || value > once.back() + kSamePlace) once.push_back(value);
  }
  return once;
}

std::size_t coordinate_index(const std::vector<double>& once, double value) {
  const auto after = ranges::lower_bound(once, value - kSamePlace);
  return static_cast<std::size_t>(after - once.begin());
}

/// Sorts points that fill a regular grid into grid order.
void order_grid(Bathymetry& depths) {
  const std::vector<double> east = distinct_coordinates(depths.east), north = distinct_coordinates(depths.north);
  const std::size_t count = east.size() * north.size();
  if (count != depths.depth.size() || east.size() < 2 || north.size() < 2) return;
  std::vector<double> ordered(count, 0.0);
  std::vector<bool> filled(count, false);
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t index =
        coordinate_index(north, depths.north[i]) * east.size() + coordinate_index(east, depths.east[i]);
    if (filled[index]) return;  // duplicate point: at least one crossing is missing
    filled[index] = true;
    ordered[index] = depths.depth[i];
  }
  for (std::size_t i = 0; i < count; ++i) {
    depths.east[i] = east[i % east.size()];
    depths.north[i] = north[i / east.size()];
  }
  depths.depth = std::move(ordered);
  depths.columns = static_cast<int>(east.size());
  depths.rows = static_cast<int>(north.size());
}

/// Detects coordinates in degrees instead of metres by the size of the area and of its cells.
void check_size(const Bathymetry& depths, BathymetryMessages& messages) {
  constexpr double kMinExtent = 10.0, kMinCell = 0.05;  // [m]
  const auto [west, east] = ranges::minmax(depths.east);
  const auto [south, north] = ranges::minmax(depths.north);
  const double cell = depths.columns > 0 ? (east - west) / (depths.columns - 1) : kMinExtent;
  if (std::max(east - west, north - south) >= kMinExtent && cell >= kMinCell) return;
  const bool degrees = std::abs(west) <= 360.0 && std::abs(south) <= 90.0;
  messages.error(0, "",
                 "an area of " + format_number(east - west, 4) + " m by " + format_number(north - south, 4) + " m" +
                     (depths.columns > 0 ? ", in cells of " + format_quantity(cell, "m", "mm", 3) : std::string()),
                 "an area large enough to lay a pipe in, with coordinates in m",
                 degrees ? "longitude and latitude in degrees? Then give " + std::string(kGeographicOrigin) : "");
}

/// Checks that points span an area and that some depth is positive.
void check_area(const Bathymetry& depths, BathymetryMessages& messages) {
  if (ranges::none_of(depths.depth, [](double depth) { return depth > 0.0; })) {
    return messages.error(0, "", "no depth above 0", "depths below the mean water level, positive downwards",
                          "environment.seabed.bathymetry_values: elevation reads heights");
  }
  if (depths.columns == 0 &&
      (distinct_coordinates(depths.east).size() < 2 || distinct_coordinates(depths.north).size() < 2)) {
    return messages.error(0, "", "points on one line", "depths over an area",
                          "a line of depths is environment.seabed.profile");
  }
  check_size(depths, messages);
}

/// Converts longitude and latitude [deg] to the plane that touches the ellipsoid at the origin; leaves out points far
/// away.
void project(Bathymetry& depths, const MapOrigin& origin, BathymetryMessages& messages) {
  Bathymetry near;
  for (std::size_t i = 0; i < depths.depth.size(); ++i) {
    if (std::abs(depths.north[i]) > 90.0 || std::abs(depths.east[i]) > 360.0) {
      return messages.error(0, "",
                            "a longitude of " + format_number(depths.east[i], 9) + " and a latitude of " +
                                format_number(depths.north[i], 9),
                            "degrees",
                            "for coordinates in m, give environment.seabed.bathymetry_origin: {east, north}");
    }
    const double lat = depths.north[i] * kDegree, lon = depths.east[i] * kDegree;
    // behind the globe the plane is meaningless
    if (std::abs(lat - *origin.lat) > 1.0 || std::cos(lon - *origin.lon) < 0.5) continue;
    const PlanPoint point = tangent_plane_point(lat, lon, *origin.lat, *origin.lon);
    if (std::hypot(point.east, point.north) > kMaxDistance) continue;
    near.east.push_back(point.east);
    near.north.push_back(point.north);
    near.depth.push_back(depths.depth[i]);
  }
  const std::size_t far = depths.depth.size() - near.depth.size();
  messages.notice("degrees converted to metres in the plane that touches the ellipsoid of WGS 84 at latitude " +
                  format_number(*origin.lat * kToDegrees, 8) + ", longitude " +
                  format_number(*origin.lon * kToDegrees, 8));
  messages.left_out(far, "point", "more than 50 km away");
  if (near.depth.size() < 3) {
    return messages.error(0, "", std::to_string(near.depth.size()) + " depths within 50 km of the origin",
                          "a bathymetry around environment.seabed.bathymetry_origin");
  }
  depths = std::move(near);
}

/// Moves the depths of a file into the frame of the model.
void place(BathymetryFile& file, const MapOrigin& origin, BathymetryMessages& messages) {
  const bool geographic = origin.lat && origin.lon;
  if (file.unit == MapUnit::degrees && !geographic) {
    return messages.error(0, "", "coordinates in degrees", kGeographicOrigin,
                          "the position of midship: degrees are converted to metres about it");
  }
  if (file.unit == MapUnit::metres && geographic) {
    return messages.error(0, "", "coordinates in m, and an origin in degrees",
                          "environment.seabed.bathymetry_origin: {east, north} in the coordinates of the file");
  }
  if (geographic) {
    project(file.depths, origin, messages);
  } else {
    for (double& east : file.depths.east) east -= origin.east;
    for (double& north : file.depths.north) north -= origin.north;
  }
  if (messages.good()) turn_depths(file.depths, origin.azimuth);
}

std::optional<Bathymetry> finish(std::optional<BathymetryFile> file, const BathymetrySettings& settings,
                                 BathymetryMessages& messages) {
  if (!file || !messages.good()) return std::nullopt;
  if (file->depths.depth.size() < 3) {
    messages.error(0, "", std::to_string(file->depths.depth.size()) + " points", "at least three");
    return std::nullopt;
  }
  place(*file, settings.origin, messages);
  if (!messages.good()) return std::nullopt;
  if (file->depths.columns == 0) order_grid(file->depths);
  check_area(file->depths, messages);
  return messages.good() ? std::optional(std::move(file->depths)) : std::nullopt;
}

/// Kinds of files, recognised by their first bytes or words.
enum class FileKind { table, esri_grid, netcdf, tiff };

bool has_ending(const std::string& path, const std::vector<std::string>& endings) {
  const std::string ending = lower_case(std::filesystem::path(path).extension().string());
  return ranges::find(endings, ending) != endings.end();
}

FileKind recognise(const std::string& path) {
  using namespace std::string_view_literals;
  std::array<char, 64> bytes{};
  std::ifstream file(path, std::ios::binary);
  file.read(bytes.data(), bytes.size());
  const std::string_view head(bytes.data(), static_cast<std::size_t>(file.gcount()));
  if (head.starts_with("CDF"sv) || head.starts_with("\x89HDF"sv)) return FileKind::netcdf;
  const bool tiff = head.starts_with("II*\0"sv) || head.starts_with("MM\0*"sv) || head.starts_with("II+\0"sv);
  if (tiff || (head.empty() && has_ending(path, {".tif", ".tiff"}))) return FileKind::tiff;
  const std::string word = lower_case(trim(head));
  const bool esri = word.starts_with("ncols") || word.starts_with("nrows") || has_ending(path, {".asc"});
  return esri ? FileKind::esri_grid : FileKind::table;
}

}  // namespace

void BathymetryMessages::error(int line, std::string key, std::string found, std::string expected, std::string hint) {
  good_ = false;
  diagnostics_.add(
      {Severity::error, path_, line, 0, std::move(key), std::move(found), std::move(expected), std::move(hint)});
}

void BathymetryMessages::notice(std::string message) {
  add_notice(diagnostics_, path_, 0, std::move(message));
}

void BathymetryMessages::left_out(std::size_t count, const std::string& noun, const std::string& rest) {
  if (count > 0) notice("left out: " + std::to_string(count) + " " + noun + (count > 1 ? "s " : " ") + rest);
}

void check_bathymetry_depth(double depth, int line, BathymetryMessages& messages) {
  constexpr double kHighest = 9000.0;
  constexpr double kNoValues[] = {-999.0, -999.9, -999.25, -9999.0, -32767.0, -32768.0};
  const bool none = ranges::any_of(kNoValues, [&](double value) { return depth == value || depth == -value; });
  if (!none && depth <= kMaxWaterDepth && depth >= -kHighest) return;
  messages.error(line, "depth", format_number(depth), "a depth of at most " + format_number(kMaxWaterDepth) + " m",
                 kNoDataHint);
}

std::optional<Bathymetry> read_depth_table(const std::string& text, const std::string& path, Diagnostics& diagnostics,
                                           const BathymetrySettings& settings) {
  BathymetryMessages messages(path, diagnostics);
  return finish(read_soundings(text, settings.values, messages), settings, messages);
}

std::optional<Bathymetry> read_ascii_grid(const std::string& text, const std::string& path, Diagnostics& diagnostics,
                                          const BathymetrySettings& settings) {
  BathymetryMessages messages(path, diagnostics);
  return finish(read_esri_grid(text, settings.values, messages), settings, messages);
}

std::optional<Bathymetry> read_bathymetry(const std::string& path, Diagnostics& diagnostics,
                                          const BathymetrySettings& settings) {
  BathymetryMessages messages(path, diagnostics);
  const FileKind kind = recognise(path);
  if (kind == FileKind::tiff) {
    messages.error(0, "", "a GeoTIFF, which cannot be read without GDAL",
                   "a table of soundings, an ESRI ASCII grid (.asc) or a netCDF grid",
                   "gdal_translate -of AAIGrid FILE.tif FILE.asc converts it");
    return std::nullopt;
  }
  if (kind == FileKind::netcdf) return finish(read_netcdf_grid(settings.values, messages), settings, messages);
  const std::optional<std::string> text = read_text_file(path, diagnostics);
  if (!text) return std::nullopt;
  return kind == FileKind::esri_grid ? read_ascii_grid(*text, path, diagnostics, settings)
                                     : read_depth_table(*text, path, diagnostics, settings);
}

}  // namespace overbend
