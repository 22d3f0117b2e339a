#include "seafiles/route_depths_reader.h"

#include <cmath>
#include <optional>

#include "base/text.h"
#include "base/units.h"
#include "seafiles/text_table.h"

namespace overbend {
namespace {

class RouteDepthsReader {
 public:
  RouteDepthsReader(const std::string& path, Diagnostics& diagnostics) : path_(path), diagnostics_(diagnostics) {}

  std::vector<RouteDepth> read(const std::string& text) {
    const TextTable table = split_table(text, ',');
    if (table.rows.empty()) {
      complain(0, "", "an empty file", "the depths along a route");
      return {};
    }
    const std::optional<double> to_metres = distance_unit(table.rows.front());
    if (!to_metres) return {};
    for (std::size_t i = 1; i < table.rows.size(); ++i) take(table.rows[i], *to_metres);
    if (good_ && points_.empty()) complain(0, "", "a header without rows", "a row per point of the route");
    return good_ ? points_ : std::vector<RouteDepth>{};
  }

 private:
  void complain(int line, std::string key, std::string found, std::string expected) {
    good_ = false;
    diagnostics_.add({Severity::error, path_, line, 0, std::move(key), std::move(found), std::move(expected), ""});
  }

  /// Returns the factor that converts the first column to metres.
  std::optional<double> distance_unit(const TextRow& head) {
    if (head.cells.size() == 2 && head.cells[1] == "depth_m") {
      if (head.cells[0] == "distance_m") return 1.0;
      if (head.cells[0] == "kp_km") return 1e3;
    }
    complain(head.line, "", "another header", "'distance_m,depth_m' or 'kp_km,depth_m'");
    return std::nullopt;
  }

  std::optional<double> number(const TextRow& row, std::size_t column, const char* name) {
    const std::optional<double> value = cell_number(row.cells[column]);
    if (!value) complain(row.line, name, "'" + for_display(row.cells[column]) + "'", "a number");
    return value;
  }

  void take(const TextRow& row, double to_metres) {
    if (row.cells.size() != 2) {
      complain(row.line, "", std::to_string(row.cells.size()) + " columns", "2, as in the header");
      return;
    }
    const auto distance = number(row, 0, "distance"), depth = number(row, 1, "depth");
    if (!distance || !depth) return;
    if (*depth <= 0.0) complain(row.line, "depth_m", format_number(*depth), "more than 0");
    const double metres = to_metres * *distance;
    if (!points_.empty() && metres <= points_.back().distance) {
      complain(row.line, "distance", format_number(*distance),
               "more than the previous distance, " + format_number(points_.back().distance / to_metres));
    }
    points_.push_back({metres, *depth});
  }

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
