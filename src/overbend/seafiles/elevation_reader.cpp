#include "seafiles/elevation_reader.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "base/text.h"
#include "base/units.h"
#include "model/site/sea_statistics.h"
#include "seafiles/column_title.h"
#include "seafiles/record_clock.h"
#include "seafiles/sentinels.h"
#include "seafiles/table_layout.h"

namespace overbend {
namespace {

constexpr std::size_t kMinRows = 20, kMaxRows = 2'000'000;
constexpr double kUneven = 0.05;        ///< Distance of an instant from an even step, in steps.
constexpr double kMaxElevation = 40.0;  ///< [m]

class ElevationReader {
 public:
  ElevationReader(const std::string& path, Diagnostics& diagnostics) : path_(path), diagnostics_(diagnostics) {}

  std::optional<ElevationRecord> read(const std::string& text) {
    const std::optional<ExportedTable> table = read_exported_table(text, path_, diagnostics_);
    if (!table) return std::nullopt;
    if (table->rows.empty()) return reject(0, "no rows", "the header time_s,elevation_m and numbers");
    if (!read_header(*table)) return std::nullopt;
    const std::size_t rows = table->rows.size() - 1;
    if (rows < kMinRows || rows > kMaxRows) {
      return reject(table->rows.back().line, std::to_string(rows) + " instants",
                    std::to_string(kMinRows) + " to " + std::to_string(kMaxRows));
    }
    RecordClock clock(path_, time_unit_, is_unix_, diagnostics_);
    for (std::size_t i = 1; i < table->rows.size(); ++i) {
      if (!read_row(*table, table->rows[i], clock)) return std::nullopt;
    }
    if (!check_steps() || !clock.finish(times_) || !subtract_mean()) return std::nullopt;
    return std::move(record_);
  }

 private:
  std::nullopt_t reject(int line, std::string found, std::string expected, std::string hint = {}) {
    diagnostics_.add({Severity::error, path_, line, 0, "", std::move(found), std::move(expected), std::move(hint)});
    return std::nullopt;
  }

  bool read_header(const ExportedTable& table) {
    const TextRow& header = table.rows.front();
    std::optional<double> unit;
    bool has_time = false;
    for (std::size_t i = 0; i < header.cells.size(); ++i) {
      const ColumnTitle title = parse_column_title(header.cells[i]);
      const std::string stated = title.unit.empty() ? bare_unit(table.unit(i)) : title.unit;
      if (is_time_title(title)) {
        has_time = true;
        time_ = i;
        time_unit_ = title_unit_factor(stated, "s") ? stated : "";
        is_unix_ = is_unix_title(title);
      } else {
        elevation_ = i;
        unit = title_unit_factor(stated, "m");
      }
    }
    columns_ = header.cells.size();
    factor_ = unit.value_or(1.0);
    if (has_time && unit && columns_ == 2) return true;
    reject(header.line, "the columns '" + join_items({header.cells.begin(), header.cells.end()}, "and") + "'",
           "time_s and elevation_m, or other titles of a time and an elevation with its unit");
    return false;
  }

  bool read_row(const ExportedTable& table, const TextRow& row, RecordClock& clock) {
    if (row.cells.size() != columns_) {
      reject(row.line, std::to_string(row.cells.size()) + " cells", "2, as in the header", row_width_hint(table, row));
      return false;
    }
    const std::optional<double> value = cell_number(row.cells[elevation_]);
    if (!value) {
      reject(row.line, "'" + for_display(row.cells[elevation_]) + "'", "a number");
      return false;
    }
    const double elevation = factor_ * *value;
    if (!(std::abs(elevation) <= kMaxElevation)) {
      reject(row.line, format_number(elevation) + " m" + (is_sentinel(*value) ? kMissingValueText : ""),
             "an elevation of at most " + format_number(kMaxElevation) + " m", "interpolate missing values");
      return false;
    }
    const std::optional<double> time = clock.read(row.line, row.cells[time_]);
    if (!time) return false;
    times_.push_back(*time);
    lines_.push_back(row.line);
    record_.elevation.push_back(elevation);
    return true;
  }

  bool check_steps() {
    const double first = times_.front();
    record_.step = (times_.back() - first) / static_cast<double>(times_.size() - 1);
    if (!(record_.step > 0.0)) {
      reject(lines_.back(), "a time of " + format_number(times_.back()) + " s", "increasing times");
      return false;
    }
    for (std::size_t i = 1; i < times_.size(); ++i) {
      const double even = first + record_.step * static_cast<double>(i);
      if (std::abs(times_[i] - even) <= kUneven * record_.step) continue;
      // Named where the step differs from the first one, which is where a gap is.
      std::size_t k = 1;
      const double step = times_[1] - times_[0];
      while (k + 1 < times_.size() && std::abs(times_[k] - times_[k - 1] - step) <= kUneven * std::abs(step)) ++k;
      reject(lines_[k],
             "a step of " + format_number(times_[k] - times_[k - 1]) + " s, the first is " + format_number(step) + " s",
             "even steps", "fill gaps by interpolation");
      return false;
    }
    return true;
  }

  bool subtract_mean() {
    std::vector<double>& y = record_.elevation;
    record_.mean = std::accumulate(y.begin(), y.end(), 0.0) / static_cast<double>(y.size());
    for (double& value : y) value -= record_.mean;
    const double hs = record_statistics(record_).hs;
    if (hs > 1e-6) return true;
    reject(0, "the same elevation in every row", "a record of waves");
    return false;
  }

  const std::string& path_;
  Diagnostics& diagnostics_;
  std::size_t time_ = 0, elevation_ = 0, columns_ = 0;
  std::string time_unit_;
  bool is_unix_ = false;
  double factor_ = 1.0;  ///< Metres in a unit of the elevation.
  std::vector<double> times_;
  std::vector<int> lines_;
  ElevationRecord record_;
};

}  // namespace

std::optional<ElevationRecord> read_elevation_text(const std::string& text, const std::string& path,
                                                   Diagnostics& diagnostics) {
  return ElevationReader(path, diagnostics).read(text);
}

}  // namespace overbend
