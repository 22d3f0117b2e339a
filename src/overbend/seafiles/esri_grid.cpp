/// ESRI ASCII grids of depths or heights.
#include <cmath>
#include <limits>
#include <map>

#include "base/ranges.h"
#include "base/text.h"
#include "base/units.h"
#include "seafiles/bathymetry_file.h"
#include "seafiles/text_table.h"

namespace overbend {
namespace {

constexpr double kUsualNoData = -9999.0;  ///< Value of a grid without NODATA_value.

/// Returns a number or NaN for the text "nan".
std::optional<double> number_or_nan(std::string_view cell) {
  if (const std::optional<double> value = cell_number(cell)) return value;
  const std::string word = lower_case(cell);
  const bool nan = word == "nan" || word == "-nan";
  return nan ? std::optional(std::numeric_limits<double>::quiet_NaN()) : std::nullopt;
}

/// Header of a grid.
struct GridHead {
  double columns = 0.0, rows = 0.0, east = 0.0, north = 0.0, dx = 0.0, dy = 0.0;
  double no_data = kUsualNoData;
  std::size_t lines = 0;
  /// True if the value is missing; header and cells may write it with different numbers of digits.
  bool empty(double value) const { return std::isnan(value) || std::abs(value - no_data) <= 1e-6 * std::abs(no_data); }
};

using Keys = std::map<std::string, double>;

std::optional<Keys> read_keys(const TextTable& table, BathymetryMessages& messages) {
  Keys keys;
  for (const TextRow& row : table.rows) {
    if (row.cells.empty() || number_or_nan(row.cells[0])) break;
    const auto value = row.cells.size() == 2 ? number_or_nan(row.cells[1]) : std::nullopt;
    const std::string key = lower_case(row.cells[0]);
    if (!value || (std::isnan(*value) && key != "nodata_value")) {
      messages.error(row.line, for_display(row.cells[0]), "no number", "a key with its number");
      return std::nullopt;
    }
    if (!keys.emplace(key, *value).second) {
      messages.error(row.line, for_display(row.cells[0]), "a second value", "each key once");
      return std::nullopt;
    }
  }
  return keys;
}

std::optional<GridHead> grid_head(const TextTable& table, BathymetryMessages& messages) {
  const std::optional<Keys> found = read_keys(table, messages);
  if (!found) return std::nullopt;
  Keys keys = *found;
  const bool centre = keys.contains("xllcenter") && keys.contains("yllcenter");
  const bool oblong = keys.contains("dx") || keys.contains("dy");
  std::vector<const char*> needed = {"ncols", "nrows", centre ? "xllcenter" : "xllcorner",
                                     centre ? "yllcenter" : "yllcorner"};
  if (oblong) {
    needed.insert(needed.end(), {"dx", "dy"});
  } else {
    needed.push_back("cellsize");
  }
  for (const char* key : needed) {
    if (!keys.contains(key)) messages.error(0, key, "nothing (the key is missing)", "the head of an ESRI ASCII grid");
  }
  if (oblong && keys.contains("cellsize")) {
    messages.error(0, "cellsize", "cellsize with dx or dy", "cellsize, or dx and dy");
  }
  if (!messages.good()) return std::nullopt;
  GridHead head;
  head.lines = keys.size();
  head.columns = keys["ncols"];
  head.rows = keys["nrows"];
  head.dx = oblong ? keys["dx"] : keys["cellsize"];
  head.dy = oblong ? keys["dy"] : head.dx;
  head.east = centre ? keys["xllcenter"] : keys["xllcorner"] + 0.5 * head.dx;
  head.north = centre ? keys["yllcenter"] : keys["yllcorner"] + 0.5 * head.dy;
  if (keys.contains("nodata_value")) head.no_data = keys["nodata_value"];
  const bool integral = head.columns == std::floor(head.columns) && head.rows == std::floor(head.rows);
  if (!integral || head.columns < 2.0 || head.rows < 2.0 || head.columns * head.rows > kMaxBathymetryCells ||
      head.dx <= 0.0 || head.dy <= 0.0) {
    messages.error(0, "",
                   "a grid of " + format_number(head.columns) + " by " + format_number(head.rows) + " cells of " +
                       format_number(head.dx) + " m" + (oblong ? " by " + format_number(head.dy) + " m" : ""),
                   "two by two cells or more, at most four million");
    return std::nullopt;
  }
  return head;
}

/// Reports the first line that is not a row of the grid, or the number of values if lines are not rows.
void report_count(const TextTable& table, const GridHead& head, std::size_t count, BathymetryMessages& messages) {
  const auto columns = static_cast<std::size_t>(head.columns);
  const auto begin = table.rows.begin() + static_cast<std::ptrdiff_t>(head.lines);
  const auto is_row = [&](const TextRow& row) { return row.cells.size() == columns; };
  const auto short_row = std::find_if_not(begin, table.rows.end(), is_row);
  const auto rows = std::count_if(begin, table.rows.end(), is_row);
  if (short_row != table.rows.end() && 2 * rows > table.rows.end() - begin) {
    messages.error(short_row->line, "", std::to_string(short_row->cells.size()) + " values",
                   std::to_string(columns) + ", as ncols states");
  } else {
    messages.error(0, "", std::to_string(count) + " values", format_number(head.columns * head.rows, 9));
  }
}

/// Returns the cell values row by row from the north-west corner.
std::vector<double> grid_values(const TextTable& table, const GridHead& head, BathymetryMessages& messages) {
  std::vector<double> values;
  for (std::size_t i = head.lines; i < table.rows.size(); ++i) {
    for (const std::string_view cell : table.rows[i].cells) {
      const auto value = number_or_nan(cell);
      if (!value) {
        messages.error(table.rows[i].line, "", "'" + for_display(cell) + "'", "a number");
        return {};
      }
      values.push_back(*value);
    }
  }
  if (static_cast<double>(values.size()) != head.columns * head.rows) {
    report_count(table, head, values.size(), messages);
  }
  return values;
}

Bathymetry make_bathymetry(const GridHead& head, const std::vector<double>& values, double sign) {
  Bathymetry depths;
  const auto columns = static_cast<std::size_t>(head.columns), rows = static_cast<std::size_t>(head.rows);
  for (std::size_t row = 0; row < rows; ++row) {
    for (std::size_t column = 0; column < columns; ++column) {
      const double value = values[(rows - 1 - row) * columns + column];
      if (head.empty(value)) continue;
      depths.east.push_back(head.east + static_cast<double>(column) * head.dx);
      depths.north.push_back(head.north + static_cast<double>(row) * head.dy);
      depths.depth.push_back(sign * value);
    }
  }
  if (depths.depth.size() == values.size()) {
    depths.columns = static_cast<int>(columns);
    depths.rows = static_cast<int>(rows);
  }
  return depths;
}

/// Returns true if the values are heights: as stated, or if most are negative.
bool are_heights(const GridHead& head, const std::vector<double>& values, std::optional<BathymetryValues> stated) {
  if (stated) return *stated == BathymetryValues::elevation;
  const auto below = ranges::count_if(values, [&](double value) { return !head.empty(value) && value < 0.0; });
  const auto above = ranges::count_if(values, [&](double value) { return !head.empty(value) && value > 0.0; });
  return below > above;
}

}  // namespace

std::optional<BathymetryFile> read_esri_grid(const std::string& text, std::optional<BathymetryValues> values,
                                             BathymetryMessages& messages) {
  const TextTable table = split_table(text, ' ');
  const auto head = grid_head(table, messages);
  if (!head) return std::nullopt;
  const std::vector<double> cells = grid_values(table, *head, messages);
  if (!messages.good()) return std::nullopt;
  const bool heights = are_heights(*head, cells, values);
  BathymetryFile file{make_bathymetry(*head, cells, heights ? -1.0 : 1.0)};
  for (const double depth : file.depths.depth) {
    if (messages.good()) check_bathymetry_depth(depth, 0, messages);
  }
  const std::size_t missing = cells.size() - file.depths.depth.size();
  messages.left_out(missing, "cell", "without data");
  if (heights) messages.notice("its values are heights, negative below the mean water level");
  return file;
}

}  // namespace overbend
