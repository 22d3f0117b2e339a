#include "seafiles/bathymetry_reader.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <filesystem>
#include <map>

#include "base/ranges.h"
#include "base/text.h"
#include "base/units.h"
#include "seafiles/text_table.h"

namespace overbend {
namespace {

constexpr double kSamePlace = 1e-6;  ///< Distance below which coordinates are equal [m].
constexpr double kMaxCells = 4'000'000;
constexpr double kMaxWaterDepth = 12'000.0;  ///< Upper limit of the key environment.water_depth [m].
constexpr double kUsualNoData = -9999.0;     ///< Value of an ASCII grid without NODATA_value.
constexpr const char* kNoDataHint = "a value for places without data? Leave these rows out, or name it as NODATA_value";

class DiagnosticSink {
 public:
  DiagnosticSink(const std::string& path, Diagnostics& diagnostics) : path_(path), diagnostics_(diagnostics) {}
  void add(int line, std::string key, std::string found, std::string expected, std::string hint = {}) {
    good = false;
    diagnostics_.add(
        {Severity::error, path_, line, 0, std::move(key), std::move(found), std::move(expected), std::move(hint)});
  }
  bool good = true;

 private:
  const std::string& path_;
  Diagnostics& diagnostics_;
};

std::string lower(std::string_view text) {
  std::string result(text);
  ranges::transform(result, result.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return result;
}

bool is_head(const TextRow& row) {
  constexpr const char* kNames[] = {"east", "north", "depth"};
  if (row.cells.size() != 3) return false;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::string cell = lower(row.cells[i]);
    if (cell != kNames[i] && cell != std::string(kNames[i]) + "_m") return false;
  }
  return true;
}

/// Accepts land above the water (negative depth) but rejects values that stand for missing data.
void check_depth(double depth, int line, DiagnosticSink& complaints) {
  constexpr double kHighest = 9000.0;
  constexpr double kNoValues[] = {-999.0, -999.9, -999.25, -9999.0, -32767.0, -32768.0};
  const bool none = ranges::any_of(kNoValues, [&](double value) { return depth == value || depth == -value; });
  if (!none && depth <= kMaxWaterDepth && depth >= -kHighest) return;
  complaints.add(line, "depth", format_number(depth), "a depth of at most " + format_number(kMaxWaterDepth) + " m",
                 kNoDataHint);
}

void take(const TextRow& row, Bathymetry& depths, DiagnosticSink& complaints) {
  if (row.cells.size() != 3) {
    complaints.add(row.line, "", std::to_string(row.cells.size()) + " columns", "3, as in the header");
    return;
  }
  double values[3] = {};
  constexpr const char* kNames[] = {"east", "north", "depth"};
  for (std::size_t i = 0; i < 3; ++i) {
    const auto value = cell_number(row.cells[i]);
    if (!value) {
      complaints.add(row.line, kNames[i], "'" + for_display(row.cells[i]) + "'", "a number");
      return;
    }
    values[i] = *value;
  }
  check_depth(values[2], row.line, complaints);
  depths.east.push_back(values[0]);
  depths.north.push_back(values[1]);
  depths.depth.push_back(values[2]);
}

/// Returns the sorted distinct coordinates.
std::vector<double> distinct_coordinates(std::vector<double> values) {
  ranges::sort(values);
  std::vector<double> once;
  for (const double value : values) {
    if (once.empty() || value > once.back() + kSamePlace) once.push_back(value);
  }
  return once;
}

std::size_t index_of_coordinate(const std::vector<double>& once, double value) {
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
        index_of_coordinate(north, depths.north[i]) * east.size() + index_of_coordinate(east, depths.east[i]);
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
void check_size(const Bathymetry& depths, DiagnosticSink& complaints) {
  constexpr double kMinExtent = 10.0, kMinCell = 0.05;  // [m]
  const auto [west, east] = ranges::minmax(depths.east);
  const auto [south, north] = ranges::minmax(depths.north);
  const double cell = depths.columns > 0 ? (east - west) / (depths.columns - 1) : kMinExtent;
  if (std::max(east - west, north - south) >= kMinExtent && cell >= kMinCell) return;
  const bool degrees = std::abs(west) <= 360.0 && std::abs(south) <= 90.0;
  complaints.add(0, "",
                 "an area of " + format_number(east - west, 4) + " m by " + format_number(north - south, 4) + " m" +
                     (depths.columns > 0 ? ", in cells of " + format_quantity(cell, "m", "mm", 3) : std::string()),
                 "an area large enough to lay a pipe in, with coordinates in m",
                 degrees ? "longitude and latitude in degrees? Project them to metres first" : "");
}

/// Checks that scattered points span an area and that some depth is positive.
void check_area(const Bathymetry& depths, DiagnosticSink& complaints) {
  if (!complaints.good) return;
  if (ranges::none_of(depths.depth, [](double depth) { return depth > 0.0; })) {
    complaints.add(0, "", "no depth above 0", "depths below the mean water level, positive downwards",
                   "only an ESRI ASCII grid may contain heights");
    return;
  }
  if (depths.columns > 0) return check_size(depths, complaints);
  if (distinct_coordinates(depths.east).size() < 2 || distinct_coordinates(depths.north).size() < 2) {
    complaints.add(0, "", "points on one line", "depths over an area",
                   "a line of depths is environment.seabed.profile");
  } else {
    check_size(depths, complaints);
  }
}

/// Header of an ESRI ASCII grid.
struct GridHead {
  double columns = 0.0, rows = 0.0, east = 0.0, north = 0.0, cell = 0.0;
  double no_data = kUsualNoData;
  std::size_t lines = 0;
  /// True if the value is NODATA; header and cells may write it with different numbers of digits.
  bool empty(double value) const { return std::abs(value - no_data) <= 1e-6 * std::abs(no_data); }
};

std::optional<GridHead> grid_head(const TextTable& table, DiagnosticSink& complaints) {
  std::map<std::string, double> keys;
  GridHead head;
  for (const TextRow& row : table.rows) {
    if (row.cells.empty() || cell_number(row.cells[0])) break;
    const auto value = row.cells.size() == 2 ? cell_number(row.cells[1]) : std::nullopt;
    if (!value) {
      complaints.add(row.line, std::string(row.cells[0]), "no number", "a key with its number");
      return std::nullopt;
    }
    keys[lower(row.cells[0])] = *value;
    ++head.lines;
  }
  const bool centre = keys.contains("xllcenter") && keys.contains("yllcenter");
  for (const char* key :
       {"ncols", "nrows", centre ? "xllcenter" : "xllcorner", centre ? "yllcenter" : "yllcorner", "cellsize"}) {
    if (!keys.contains(key)) complaints.add(0, key, "nothing (the key is missing)", "the head of an ESRI ASCII grid");
  }
  if (!complaints.good) return std::nullopt;
  head.columns = keys["ncols"];
  head.rows = keys["nrows"];
  head.cell = keys["cellsize"];
  head.east = centre ? keys["xllcenter"] : keys["xllcorner"] + 0.5 * head.cell;
  head.north = centre ? keys["yllcenter"] : keys["yllcorner"] + 0.5 * head.cell;
  if (keys.contains("nodata_value")) head.no_data = keys["nodata_value"];
  const bool integral = head.columns == std::floor(head.columns) && head.rows == std::floor(head.rows);
  if (!integral || head.columns < 2.0 || head.rows < 2.0 || head.columns * head.rows > kMaxCells || head.cell <= 0.0) {
    complaints.add(0, "",
                   "a grid of " + format_number(head.columns) + " by " + format_number(head.rows) + " cells of " +
                       format_number(head.cell) + " m",
                   "two by two cells or more, at most four million");
    return std::nullopt;
  }
  return head;
}

/// Returns the cell values row by row from the north-west corner.
std::vector<double> grid_values(const TextTable& table, const GridHead& head, DiagnosticSink& complaints) {
  std::vector<double> values;
  for (std::size_t i = head.lines; i < table.rows.size(); ++i) {
    for (const std::string_view cell : table.rows[i].cells) {
      const auto value = cell_number(cell);
      if (!value) {
        complaints.add(table.rows[i].line, "", "'" + for_display(cell) + "'", "a number");
        return {};
      }
      values.push_back(*value);
    }
  }
  if (static_cast<double>(values.size()) != head.columns * head.rows) {
    complaints.add(0, "", std::to_string(values.size()) + " values", format_number(head.columns * head.rows, 9));
  }
  return values;
}

Bathymetry make_bathymetry(const GridHead& head, const std::vector<double>& values, double sign) {
  Bathymetry depths;
  const auto columns = static_cast<std::size_t>(head.columns), rows = static_cast<std::size_t>(head.rows);
  bool complete = true;
  for (std::size_t row = 0; row < rows; ++row) {
    for (std::size_t column = 0; column < columns; ++column) {
      const double value = values[(rows - 1 - row) * columns + column];
      complete = complete && !head.empty(value);
      if (head.empty(value)) continue;
      depths.east.push_back(head.east + static_cast<double>(column) * head.cell);
      depths.north.push_back(head.north + static_cast<double>(row) * head.cell);
      depths.depth.push_back(sign * value);
    }
  }
  if (complete) {
    depths.columns = static_cast<int>(columns);
    depths.rows = static_cast<int>(rows);
  }
  return depths;
}

}  // namespace

std::optional<Bathymetry> read_depth_table(const std::string& text, const std::string& path, Diagnostics& diagnostics) {
  DiagnosticSink complaints(path, diagnostics);
  const TextTable table = split_table(text, ',');
  if (table.rows.empty() || !is_head(table.rows.front())) {
    complaints.add(table.rows.empty() ? 0 : table.rows.front().line, "", "another header", "'east,north,depth'",
                   "in m, east and north of midship");
    return std::nullopt;
  }
  Bathymetry depths;
  for (std::size_t i = 1; i < table.rows.size() && complaints.good; ++i) take(table.rows[i], depths, complaints);
  if (complaints.good && depths.depth.size() < 3) {
    complaints.add(0, "", std::to_string(depths.depth.size()) + " points", "at least three");
  }
  if (!complaints.good) return std::nullopt;
  order_grid(depths);
  check_area(depths, complaints);
  return complaints.good ? std::optional(depths) : std::nullopt;
}

std::optional<Bathymetry> read_ascii_grid(const std::string& text, const std::string& path, Diagnostics& diagnostics) {
  DiagnosticSink complaints(path, diagnostics);
  const TextTable table = split_table(text, ' ');
  const auto head = grid_head(table, complaints);
  if (!head) return std::nullopt;
  const std::vector<double> values = grid_values(table, *head, complaints);
  if (!complaints.good) return std::nullopt;
  const auto below = ranges::count_if(values, [&](double value) { return !head->empty(value) && value < 0.0; });
  const auto above = ranges::count_if(values, [&](double value) { return !head->empty(value) && value > 0.0; });
  Bathymetry depths = make_bathymetry(*head, values, below > above ? -1.0 : 1.0);
  for (const double depth : depths.depth) {
    if (complaints.good) check_depth(depth, 0, complaints);
  }
  check_area(depths, complaints);
  return complaints.good ? std::optional(depths) : std::nullopt;
}

std::optional<Bathymetry> read_bathymetry(const std::string& path, Diagnostics& diagnostics) {
  const std::string ending = lower(std::filesystem::path(path).extension().string());
  if (ending == ".tif" || ending == ".tiff") {
    DiagnosticSink(path, diagnostics)
        .add(0, "", "a GeoTIFF, which cannot be read without GDAL", "a CSV file or an ESRI ASCII grid (.asc)",
             "gdal_translate -of AAIGrid FILE.tif FILE.asc converts it");
    return std::nullopt;
  }
  const std::optional<std::string> text = read_text_file(path, diagnostics);
  if (!text) return std::nullopt;
  return ending == ".asc" ? read_ascii_grid(*text, path, diagnostics) : read_depth_table(*text, path, diagnostics);
}

}  // namespace overbend
