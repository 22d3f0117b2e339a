/// Tables of soundings: east, north and depth or height.
#include <array>
#include <cmath>

#include "base/constants.h"
#include "base/ranges.h"
#include "base/text.h"
#include "base/units.h"
#include "seafiles/bathymetry_file.h"
#include "seafiles/column_title.h"
#include "seafiles/table_layout.h"

namespace overbend {
namespace {

using Names = std::vector<std::string>;

/// Columns of the table, and factors to m or deg.
struct Columns {
  std::array<std::size_t, 3> index = {0, 1, 2};  ///< Indices of east, north and depth.
  std::array<double, 3> factor = {1.0, 1.0, 1.0};
  MapUnit unit = MapUnit::unstated;
  std::optional<BathymetryValues> values;  ///< As the header states.
};

constexpr std::array<const char*, 3> kNames = {"east", "north", "depth"};
constexpr const char* kValuesHint =
    "environment.seabed.bathymetry_values: elevation (land is left out) or depth states which";

class SoundingsReader {
 public:
  SoundingsReader(std::optional<BathymetryValues> values, BathymetryMessages& messages)
      : stated_(values), messages_(messages) {}

  std::optional<BathymetryFile> read(const std::string& text) {
    std::optional<ExportedTable> table = read_exported_table(text, messages_.path(), messages_.diagnostics());
    if (!table || !find_columns(*table)) return std::nullopt;
    file_.unit = columns_.unit;
    for (std::size_t i = table->has_header ? 1 : 0; i < table->rows.size() && messages_.good(); ++i) {
      take(*table, table->rows[i]);
    }
    if (!messages_.good()) return std::nullopt;
    settle_signs();
    messages_.left_out(missing_, "row", "without a value");
    return messages_.good() ? std::optional(std::move(file_)) : std::nullopt;
  }

 private:
  bool find_columns(const ExportedTable& table) {
    if (table.rows.empty()) return reject_header(0);
    if (table.has_header) return read_header(table);
    if (table.width == 3) return true;
    messages_.error(table.rows.front().line, "", std::to_string(table.width) + " columns without a header",
                    "3 columns, east, north and depth, or a header that names them",
                    row_width_hint(table, table.rows.front()));
    return false;
  }

  bool reject_header(int line) {
    messages_.error(line, "", "another header", "'east,north,depth'", "in m, east and north of midship");
    return false;
  }

  bool read_header(const ExportedTable& table) {
    const TextRow& header = table.rows.front();
    std::array<bool, 3> found{};
    Names unused;
    bool degrees = false;
    for (std::size_t i = 0; i < header.cells.size(); ++i) {
      ColumnTitle title = parse_column_title(header.cells[i]);
      if (title.unit.empty()) title.unit = bare_unit(table.unit(i));
      const std::optional<std::size_t> which = find_column(title.name, degrees);
      if (!which) {
        unused.push_back(for_display(header.cells[i]));
        continue;
      }
      if (found[*which]) {
        messages_.error(header.line, "", "two columns for " + std::string(kNames[*which]), "one");
        return false;
      }
      found[*which] = true;
      columns_.index[*which] = i;
      if (*which == 2) columns_.values = header_values(title.name);
      if (!take_unit(header.line, title, *which, degrees)) return false;
    }
    if (!ranges::all_of(found, [](bool column) { return column; })) return reject_header(header.line);
    if (!unused.empty()) messages_.notice("columns that are not used: " + join_items(unused, "and"));
    return true;
  }

  /// Returns 0 for east, 1 for north, 2 for the depth; sets `degrees` for longitude and latitude.
  static std::optional<std::size_t> find_column(const std::string& name, bool& degrees) {
    static const Names kEast = {"east", "easting", "eastings", "x", "e"}, kLongitude = {"lon", "long", "longitude"},
                       kNorth = {"north", "northing", "northings", "y", "n"}, kLatitude = {"lat", "latitude"},
                       kDepth = {"depth", "water_depth", "water depth", "z", "elevation", "height", "altitude"};
    const auto is_in = [&](const Names& names) { return ranges::find(names, name) != names.end(); };
    degrees = is_in(kLongitude) || is_in(kLatitude);
    if (is_in(kEast) || is_in(kLongitude)) return 0;
    if (is_in(kNorth) || is_in(kLatitude)) return 1;
    return is_in(kDepth) ? std::optional<std::size_t>(2) : std::nullopt;
  }

  static std::optional<BathymetryValues> header_values(const std::string& name) {
    if (name == "z") return std::nullopt;
    return name.find("depth") != std::string::npos ? BathymetryValues::depth : BathymetryValues::elevation;
  }

  bool take_unit(int line, const ColumnTitle& title, std::size_t which, bool degrees) {
    const std::optional<double> metres = title_unit_factor(title.unit, "m");
    const std::optional<double> radians = title_unit_factor(title.unit, "rad");
    const bool good = title.unit.empty() || (metres && !degrees) || (radians && which < 2);
    if (!good) {
      messages_.error(line, kNames[which], "the unit '" + for_display(title.unit) + "'",
                      which == 2 ? "a unit of length"
                      : degrees  ? "degrees"
                                 : "a unit of length, or degrees");
      return false;
    }
    if (metres) columns_.factor[which] = *metres;
    if (metres && *metres != 1.0) messages_.notice(std::string(kNames[which]) + " is converted from " + title.unit);
    if (radians) columns_.factor[which] = *radians * kToDegrees;
    if (which == 2) return true;
    const MapUnit unit = degrees || radians ? MapUnit::degrees : metres ? MapUnit::metres : MapUnit::unstated;
    if (columns_.unit == MapUnit::unstated || columns_.unit == unit) {
      columns_.unit = unit;
    } else if (unit != MapUnit::unstated) {
      messages_.error(line, kNames[which], "coordinates in metres and in degrees", "one unit for both");
      return false;
    }
    return true;
  }

  void take(const ExportedTable& table, const TextRow& row) {
    if (row.cells.size() != table.width) {
      messages_.error(row.line, "", std::to_string(row.cells.size()) + " columns",
                      std::to_string(table.width) + (table.has_header ? ", as in the header" : ", as in the first row"),
                      row_width_hint(table, row));
      return;
    }
    const std::string_view depth = row.cells[columns_.index[2]];
    if (depth.empty() || lower_case(depth) == "nan") {
      ++missing_;
      return;
    }
    std::array<double, 3> values{};
    for (std::size_t i = 0; i < 3; ++i) {
      const std::string_view cell = row.cells[columns_.index[i]];
      const auto value = cell_number(cell);
      if (!value) return messages_.error(row.line, kNames[i], "'" + for_display(cell) + "'", "a number");
      values[i] = *value * columns_.factor[i];
    }
    check_bathymetry_depth(std::abs(values[2]), row.line, messages_);
    file_.depths.east.push_back(values[0]);
    file_.depths.north.push_back(values[1]);
    file_.depths.depth.push_back(values[2]);
    rows_.push_back(row.line);
  }

  /// Makes the values depths: as stated by the key or the header, otherwise by the sign that all values have.
  void settle_signs() {
    const std::optional<BathymetryValues> values = stated_ ? stated_ : columns_.values;
    if (values == BathymetryValues::depth) return;
    const auto& depth = file_.depths.depth;
    const auto below = ranges::count_if(depth, [](double value) { return value < 0.0; });
    const auto above = ranges::count_if(depth, [](double value) { return value > 0.0; });
    if (!values && below > 0 && above > 0) return reject_signs(below < above);
    if (!values && below == 0) return;
    if (below == 0) {
      return messages_.error(0, "", "no height below 0", "heights of the seabed, negative below the mean water level",
                             "environment.seabed.bathymetry_values: depth reads depths");
    }
    leave_out_land();
    for (double& value : file_.depths.depth) value = 0.0 - value;
    messages_.notice("its values are heights, negative below the mean water level");
  }

  void reject_signs(bool mostly_depths) {
    const auto minority =
        ranges::find_if(file_.depths.depth, [&](double value) { return mostly_depths ? value < 0.0 : value > 0.0; });
    const auto i = static_cast<std::size_t>(minority - file_.depths.depth.begin());
    messages_.error(
        rows_[i], "depth",
        format_number(*minority, 9) + (mostly_depths ? " among positive depths" : " among negative heights"),
        "values of one sign, or a statement whether they are depths or heights", kValuesHint);
  }

  void leave_out_land() {
    Bathymetry water;
    for (std::size_t i = 0; i < file_.depths.depth.size(); ++i) {
      if (file_.depths.depth[i] > 0.0) continue;
      water.east.push_back(file_.depths.east[i]);
      water.north.push_back(file_.depths.north[i]);
      water.depth.push_back(file_.depths.depth[i]);
    }
    const std::size_t land = file_.depths.depth.size() - water.depth.size();
    messages_.left_out(land, "point", kLand);
    file_.depths = std::move(water);
  }

  std::optional<BathymetryValues> stated_;
  BathymetryMessages& messages_;
  Columns columns_;
  BathymetryFile file_;
  std::vector<int> rows_;  ///< Line of each point.
  std::size_t missing_ = 0;
};

}  // namespace

std::optional<BathymetryFile> read_soundings(const std::string& text, std::optional<BathymetryValues> values,
                                             BathymetryMessages& messages) {
  return SoundingsReader(values, messages).read(text);
}

}  // namespace overbend
