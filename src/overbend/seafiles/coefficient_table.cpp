#include "seafiles/coefficient_table.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "base/constants.h"
#include "base/text.h"
#include "base/units.h"
#include "seafiles/table_layout.h"
#include "seafiles/text_table.h"

namespace overbend {
namespace {

constexpr double kMaxGap = 60.0;  ///< Largest accepted gap: a table every 30 deg with one row missing [deg].
constexpr std::array kHeader = {"angle_deg", "cx", "cy", "cz"};

class CoefficientReader {
 public:
  CoefficientReader(const std::string& path, Diagnostics& diagnostics) : path_(path), diagnostics_(diagnostics) {}

  std::vector<CoefficientRow> read(const TextTable& table) {
    if (table.rows.empty() || !is_header(table.rows.front())) {
      const int line = table.rows.empty() ? 0 : table.rows.front().line;
      complain(line, "", table.rows.empty() ? "an empty file" : "another first row", "the header 'angle_deg,cx,cy,cz'");
      return {};
    }
    for (std::size_t i = 1; i < table.rows.size(); ++i) take(table.rows[i]);
    if (good_) check_circle();
    if (good_ && half_) mirror();
    return good_ ? rows_ : std::vector<CoefficientRow>{};
  }

 private:
  void complain(int line, std::string key, std::string found, std::string expected) {
    good_ = false;
    diagnostics_.add({Severity::error, path_, line, 0, std::move(key), std::move(found), std::move(expected), {}});
  }

  static bool is_header(const TextRow& row) {
    if (row.cells.size() != kHeader.size()) return false;
    for (std::size_t i = 0; i < kHeader.size(); ++i) {
      if (row.cells[i] != kHeader[i]) return false;
    }
    return true;
  }

  void take(const TextRow& row) {
    if (row.cells.size() != kHeader.size()) {
      return complain(row.line, "", std::to_string(row.cells.size()) + " columns", "4, as in the header");
    }
    std::array<double, 4> values{};
    for (std::size_t i = 0; i < values.size(); ++i) {
      const std::optional<double> value = cell_number(row.cells[i]);
      if (!value) return complain(row.line, kHeader[i], "'" + for_display(row.cells[i]) + "'", "a number");
      values[i] = *value;
    }
    if (!rows_.empty() && values[0] <= rows_.back().angle / kDegree + 1e-9) {
      return complain(row.line, kHeader[0], format_number(values[0]), "more than the angle before it");
    }
    rows_.push_back({values[0] * kDegree, values[1], values[2], values[3]});
    check_size(row.line, values);
  }

  /// Warns if the values look like forces instead of coefficients.
  void check_size(int line, const std::array<double, 4>& values) {
    constexpr double kMaxCoefficient = 10.0;
    const double max_coefficient = std::max({std::abs(values[1]), std::abs(values[2]), std::abs(values[3])});
    if (max_coefficient <= kMaxCoefficient || size_reported_) return;
    size_reported_ = true;
    diagnostics_.add({Severity::warning, path_, line, 0, "",
                      "a coefficient of " + format_number(max_coefficient) +
                          "; coefficients of ships are below 3. Are these forces?",
                      "", ""});
  }

  void check_circle() {
    if (rows_.size() < 3) {
      return complain(0, "", std::to_string(rows_.size()) + " rows", "a table over the full circle");
    }
    const double first = rows_.front().angle / kDegree, last = rows_.back().angle / kDegree;
    half_ = std::abs(first) < 1e-6 && std::abs(last - 180.0) < 1e-6;
    double gap = half_ ? 0.0 : first + 360.0 - last;
    for (std::size_t i = 1; i < rows_.size(); ++i) gap = std::max(gap, (rows_[i].angle - rows_[i - 1].angle) / kDegree);
    if (last - first > 360.0 + 1e-6) complain(0, kHeader[0], "more than one turn", "angles within 360 deg");
    if (gap > kMaxGap + 1e-6) {
      complain(0, kHeader[0], "a gap of " + format_number(gap) + " deg",
               "rows over the full circle, or from 0 to 180 deg");
    }
  }

  /// Adds the other side of a symmetric hull.
  void mirror() {
    for (std::size_t i = rows_.size() - 1; i-- > 1;) {
      const CoefficientRow& row = rows_[i];
      rows_.push_back({2.0 * std::numbers::pi - row.angle, row.cx, -row.cy, -row.cz});
    }
  }

  std::string path_;
  Diagnostics& diagnostics_;
  std::vector<CoefficientRow> rows_;
  bool good_ = true, half_ = false, size_reported_ = false;
};

}  // namespace

std::vector<CoefficientRow> read_coefficient_table(const std::string& path, Diagnostics& diagnostics) {
  const std::optional<std::string> text = read_text_file(path, diagnostics);
  if (!text) return {};
  const std::optional<ExportedTable> table = read_exported_table(*text, path, diagnostics);
  return table ? CoefficientReader(path, diagnostics).read(*table) : std::vector<CoefficientRow>{};
}

}  // namespace overbend
