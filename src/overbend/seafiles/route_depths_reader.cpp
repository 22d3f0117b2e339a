#include "seafiles/route_depths_reader.h"

#include <cmath>
#include <optional>

#include "base/text.h"
#include "base/units.h"
#include "seafiles/column_title.h"
#include "seafiles/table_layout.h"
#include "seafiles/text_table.h"

namespace overbend {
namespace {

class RouteDepthsReader {
 public:
  RouteDepthsReader(const std::string& path, Diagnostics& diagnostics) : path_(path), diagnostics_(diagnostics) {}

  std::vector<RouteDepth> read(const std::string& text) {
    const std::optional<ExportedTable> table = read_exported_table(text, path_, diagnostics_);
    if (!table) return {};
    if (table->rows.empty()) {
      complain(0, "", "an empty file", "the depths along a route");
      return {};
    }
    if (!read_header(*table)) return {};
    for (std::size_t i = 1; i < table->rows.size(); ++i) take(*table, table->rows[i]);
    if (good_ && points_.empty()) complain(0, "", "a header without rows", "a row per point of the route");
    return good_ ? points_ : std::vector<RouteDepth>{};
  }

 private:
  void complain(int line, std::string key, std::string found, std::string expected, std::string hint = {}) {
    good_ = false;
    diagnostics_.add(
        {Severity::error, path_, line, 0, std::move(key), std::move(found), std::move(expected), std::move(hint)});
  }

  /// Finds the columns of distance and depth and their units.
  bool read_header(const ExportedTable& table) {
    const TextRow& header = table.rows.front();
    std::vector<std::string> unused;
    for (std::size_t i = 0; i < header.cells.size(); ++i) {
      ColumnTitle title = parse_column_title(header.cells[i]);
      if (title.unit.empty()) title.unit = bare_unit(table.unit(i));
      const bool along = title.name == "distance" || title.name == "kp";
      const bool below = title.name == "depth" || title.name == "water depth" || title.name == "water_depth";
      const bool height = title.name == "elevation" || title.name == "height";
      std::optional<std::size_t>& column = along ? distance_column_ : depth_column_;
      const std::optional<double> factor = title_unit_factor(title.unit, "m");
      if (!along && !below && !height) {
        unused.push_back(for_display(header.cells[i]));
        continue;
      }
      if (!factor || column) return reject_header(header.line);
      column = i;
      (along ? to_metres_ : depth_factor_) = height ? -*factor : *factor;
      if (height) add_notice(diagnostics_, path_, header.line, "its heights are read as depths of the opposite sign");
    }
    if (!distance_column_ || !depth_column_) return reject_header(header.line);
    if (!unused.empty()) {
      add_notice(diagnostics_, path_, header.line, "columns that are not used: " + join_items(unused, "and"));
    }
    return true;
  }

  bool reject_header(int line) {
    complain(line, "", "another header", "'distance_m,depth_m' or 'kp_km,depth_m'",
             "a column of distance or kp and one of depth or elevation, each with its unit");
    return false;
  }

  std::optional<double> number(const TextRow& row, std::size_t column, const char* name) {
    const std::optional<double> value = cell_number(row.cells[column]);
    if (!value) complain(row.line, name, "'" + for_display(row.cells[column]) + "'", "a number");
    return value;
  }

  void take(const ExportedTable& table, const TextRow& row) {
    if (row.cells.size() != table.width) {
      complain(row.line, "", std::to_string(row.cells.size()) + " columns",
               std::to_string(table.width) + ", as in the header", row_width_hint(table, row));
      return;
    }
    const auto distance = number(row, *distance_column_, "distance"), depth = number(row, *depth_column_, "depth");
    if (!distance || !depth) return;
    const double below = depth_factor_ * *depth;
    if (below <= 0.0) {
      complain(row.line, depth_factor_ > 0.0 ? "depth_m" : "elevation", format_number(*depth),
               depth_factor_ > 0.0 ? "more than 0" : "less than 0");
    }
    const double metres = to_metres_ * *distance;
    if (!points_.empty() && metres <= points_.back().distance) {
      complain(row.line, "distance", format_number(*distance),
               "more than the previous distance, " + format_number(points_.back().distance / to_metres_));
    }
    points_.push_back({metres, below});
  }

  std::optional<std::size_t> distance_column_, depth_column_;
  double to_metres_ = 1.0, depth_factor_ = 1.0;  ///< To m; the latter is negative for heights.
  std::string path_;
  Diagnostics& diagnostics_;
  bool good_ = true;
  std::vector<RouteDepth> points_;
};

}  // namespace

std::vector<RouteDepth> read_route_depths_text(const std::string& text, const std::string& path,
                                               Diagnostics& diagnostics) {
  return RouteDepthsReader(path, diagnostics).read(text);
}

std::vector<RouteDepth> read_route_depths(const std::string& path, Diagnostics& diagnostics) {
  const std::optional<std::string> text = read_text_file(path, diagnostics);
  return text ? read_route_depths_text(*text, path, diagnostics) : std::vector<RouteDepth>{};
}

}  // namespace overbend
