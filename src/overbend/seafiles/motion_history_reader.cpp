#include "seafiles/motion_history_reader.h"

#include <algorithm>

#include "base/constants.h"
#include "base/ranges.h"
#include "base/text.h"
#include "seafiles/motion_columns.h"
#include "seafiles/motion_record_checks.h"
#include "seafiles/record_clock.h"
#include "seafiles/table_layout.h"
#include "seafiles/text_table.h"

namespace overbend {
namespace {

constexpr int kMaxErrors = 10;

class HistoryReader {
 public:
  HistoryReader(const std::string& file, const MotionColumns& keys, Diagnostics& diagnostics)
      : file_(file), keys_(keys), diagnostics_(diagnostics), errors_before_(diagnostics.error_count()) {}

  std::optional<MotionRecord> read(const std::string& text) {
    const std::optional<ExportedTable> table = read_exported_table(text, file_, diagnostics_);
    if (!table) return std::nullopt;
    if (table->rows.empty()) {
      complain(0, "no rows", "a header such as time_s,surge_m,sway_m,heave_m,roll_deg,pitch_deg,yaw_deg and numbers");
      return std::nullopt;
    }
    std::optional<std::vector<MotionColumn>> columns = find_motion_columns(*table, keys_, file_, diagnostics_);
    if (!columns) return std::nullopt;
    columns_ = std::move(*columns);
    read_rows(*table);
    if (errors() > 0) return std::nullopt;
    for (const MotionColumn& column : columns_) {
      if (column.quantity == MotionColumn::Quantity::freedom) record_.given[column.freedom] = true;
    }
    record_.history.source = file_;
    return std::move(record_);
  }

 private:
  int errors() const { return diagnostics_.error_count() - errors_before_; }

  void complain(int line, const std::string& found, const std::string& expected, const std::string& hint = {}) {
    diagnostics_.add({Severity::error, file_, line, 0, "", found, expected, hint});
  }

  void read_rows(const ExportedTable& table) {
    const auto time = static_cast<std::size_t>(
        ranges::find(columns_, MotionColumn::Quantity::time, &MotionColumn::quantity) - columns_.begin());
    RecordClock clock(file_, columns_[time].unit, columns_[time].is_unix, diagnostics_);
    for (std::size_t i = 1; i < table.rows.size() && errors() < kMaxErrors; ++i) {
      read_row(table, table.rows[i], time, clock);
      if (errors() > 0 && !clock.is_recognised()) return;
    }
    const std::size_t instants = record_.history.time.size();
    if (errors() == 0 && instants < 2) {
      complain(table.rows.back().line, std::to_string(instants) + " instants", "at least two");
    }
    if (errors() == 0) clock.finish(record_.history.time);
  }

  void read_row(const ExportedTable& table, const TextRow& row, std::size_t time_column, RecordClock& clock) {
    if (row.cells.size() != columns_.size()) {
      complain(row.line, std::to_string(row.cells.size()) + " cells",
               std::to_string(columns_.size()) + ", as many as in the header", row_width_hint(table, row));
      return;
    }
    std::array<double, 6> freedoms{};
    for (std::size_t i = 0; i < columns_.size(); ++i) {
      if (columns_[i].quantity != MotionColumn::Quantity::freedom) continue;
      const std::optional<double> value = cell_number(row.cells[i]);
      if (!value) {
        complain(row.line, "'" + for_display(row.cells[i]) + "'", "a number for " + columns_[i].label);
        return;
      }
      freedoms[columns_[i].freedom] = columns_[i].factor * *value;
    }
    const std::optional<double> time = clock.read(row.line, row.cells[time_column]);
    if (!time) return;
    record_.history.time.push_back(*time);
    record_.history.freedoms.push_back(freedoms);
    record_.lines.push_back(row.line);
  }

  const std::string& file_;
  const MotionColumns& keys_;
  Diagnostics& diagnostics_;
  int errors_before_;
  std::vector<MotionColumn> columns_;
  MotionRecord record_;
};

}  // namespace

std::optional<MotionHistory> read_motion_history(const std::string& file, double heading, Diagnostics& diagnostics,
                                                 const MotionColumns& columns) {
  const std::optional<std::string> text = read_text_file(file, diagnostics);
  if (!text) return std::nullopt;
  std::optional<MotionRecord> record = HistoryReader(file, columns, diagnostics).read(*text);
  if (!record) return std::nullopt;
  const int errors = diagnostics.error_count();
  check_motion_values(*record, diagnostics);
  if (diagnostics.error_count() > errors) return std::nullopt;
  unwrap_angles(*record);
  check_motion_record(*record, heading, diagnostics);
  return std::move(record->history);
}

}  // namespace overbend
