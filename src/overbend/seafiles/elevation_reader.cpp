#include "seafiles/elevation_reader.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "base/text.h"
#include "base/units.h"
#include "model/site/sea_statistics.h"
#include "seafiles/sentinels.h"
#include "seafiles/text_table.h"

namespace overbend {
namespace {

constexpr std::size_t kMinRows = 20, kMaxRows = 2'000'000;
constexpr double kUneven = 0.05;        ///< Distance of an instant from an even step, in steps.
constexpr double kMaxElevation = 40.0;  ///< [m]

class ElevationReader {
 public:
  ElevationReader(const std::string& path, Diagnostics& diagnostics) : path_(path), diagnostics_(diagnostics) {}

  std::optional<ElevationRecord> read(const std::string& text) {
    const TextTable table = split_table(text, ',');
    if (table.rows.empty()) return reject(0, "no rows", "the header time_s,elevation_m and numbers");
    if (!read_header(table.rows.front())) return std::nullopt;
    const std::size_t rows = table.rows.size() - 1;
    if (rows < kMinRows || rows > kMaxRows) {
      return reject(table.rows.back().line, std::to_string(rows) + " instants",
                    std::to_string(kMinRows) + " to " + std::to_string(kMaxRows));
    }
    for (std::size_t i = 1; i < table.rows.size(); ++i) {
      if (!read_row(table.rows[i])) return std::nullopt;
    }
    if (!check_steps() || !subtract_mean()) return std::nullopt;
    return std::move(record_);
  }

 private:
  std::nullopt_t reject(int line, std::string found, std::string expected, std::string hint = {}) {
    diagnostics_.add({Severity::error, path_, line, 0, "", std::move(found), std::move(expected), std::move(hint)});
    return std::nullopt;
  }

  bool read_header(const TextRow& header) {
    const auto find = [&](std::string_view name) {
      return static_cast<std::size_t>(std::find(header.cells.begin(), header.cells.end(), name) - header.cells.begin());
    };
    time_ = find("time_s");
    elevation_ = find("elevation_m");
    columns_ = header.cells.size();
    if (time_ < columns_ && elevation_ < columns_ && columns_ == 2) return true;
    reject(header.line, "the columns '" + join_items({header.cells.begin(), header.cells.end()}, "and") + "'",
           "time_s and elevation_m");
    return false;
  }

  bool read_row(const TextRow& row) {
    if (row.cells.size() != columns_) {
      reject(row.line, std::to_string(row.cells.size()) + " cells", "2, as in the header");
      return false;
    }
    const std::optional<double> time = cell_number(row.cells[time_]), elevation = cell_number(row.cells[elevation_]);
    if (!time || !elevation) {
      reject(row.line, "'" + for_display(row.cells[time ? elevation_ : time_]) + "'", "a number");
      return false;
    }
    if (!(std::abs(*elevation) <= kMaxElevation)) {
      reject(row.line, format_number(*elevation) + " m" + (is_sentinel(*elevation) ? kMissingValueText : ""),
             "an elevation of at most " + format_number(kMaxElevation) + " m", "interpolate missing values");
      return false;
    }
    times_.push_back(*time);
    lines_.push_back(row.line);
    record_.elevation.push_back(*elevation);
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
