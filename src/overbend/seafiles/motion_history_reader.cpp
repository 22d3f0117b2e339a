#include "seafiles/motion_history_reader.h"

#include <algorithm>

#include "base/constants.h"
#include "base/text.h"
#include "seafiles/motion_record_checks.h"
#include "seafiles/text_table.h"

namespace overbend {
namespace {

constexpr int kMaxErrors = 10;

std::vector<std::string> column_names() {
  std::vector<std::string> names = {"time_s"};
  names.insert(names.end(), kMotionColumns.begin(), kMotionColumns.end());
  return names;
}

class HistoryReader {
 public:
  HistoryReader(std::string file, Diagnostics& diagnostics) : file_(std::move(file)), diagnostics_(diagnostics) {}

  std::optional<MotionRecord> read(const std::string& text) {
    const TextTable table = split_table(text, ',');
    if (table.rows.empty()) {
      complain(0, "no rows", "a header such as time_s,surge_m,sway_m,heave_m,roll_deg,pitch_deg,yaw_deg and numbers");
      return std::nullopt;
    }
    read_header(table.rows.front());
    if (complaints_ > 0) return std::nullopt;
    for (std::size_t i = 1; i < table.rows.size() && complaints_ < kMaxErrors; ++i) read_row(table.rows[i]);
    const std::size_t instants = record_.history.time.size();
    if (complaints_ == 0 && instants < 2) {
      complain(table.rows.back().line, std::to_string(instants) + " instants", "at least two");
    }
    if (complaints_ > 0) return std::nullopt;
    record_.history.source = file_;
    return std::move(record_);
  }

 private:
  void complain(int line, const std::string& found, const std::string& expected) {
    ++complaints_;
    diagnostics_.add({Severity::error, file_, line, 0, "", found, expected, ""});
  }

  void read_header(const TextRow& header) {
    for (const std::string_view cell : header.cells) {
      const auto known = std::find(names_.begin(), names_.end(), cell);
      if (known == names_.end()) {
        complain(header.line, "a column '" + for_display(cell) + "'", join_choices(names_));
        return;
      }
      const auto column = static_cast<std::size_t>(known - names_.begin());
      if (std::find(columns_.begin(), columns_.end(), column) != columns_.end()) {
        complain(header.line, "the column '" + *known + "' twice", "each column once");
      }
      columns_.push_back(column);
      if (column > 0) record_.given[column - 1] = true;
    }
    if (std::find(columns_.begin(), columns_.end(), 0U) == columns_.end()) {
      complain(header.line, "a header without time_s", "time_s and the degrees of freedom");
    }
  }

  void read_row(const TextRow& row) {
    if (row.cells.size() != columns_.size()) {
      complain(row.line, std::to_string(row.cells.size()) + " cells",
               std::to_string(columns_.size()) + ", as many as in the header");
      return;
    }
    double time = 0.0;
    std::array<double, 6> freedoms{};
    for (std::size_t i = 0; i < columns_.size(); ++i) {
      const std::optional<double> value = cell_number(row.cells[i]);
      if (!value) {
        complain(row.line, "'" + for_display(row.cells[i]) + "'", "a number for " + names_[columns_[i]]);
        return;
      }
      if (columns_[i] == 0) {
        time = *value;
      } else {
        freedoms[columns_[i] - 1] = columns_[i] > 3 ? *value * kDegree : *value;
      }
    }
    MotionHistory& history = record_.history;
    if (!history.time.empty() && time <= history.time.back()) {
      complain(row.line, "a time of " + for_display(row.cells[time_column()]) + " s",
               "a later time than in the previous row");
      return;
    }
    history.time.push_back(time);
    history.freedoms.push_back(freedoms);
    record_.lines.push_back(row.line);
  }

  std::size_t time_column() const {
    return static_cast<std::size_t>(std::find(columns_.begin(), columns_.end(), 0U) - columns_.begin());
  }

  std::string file_;
  Diagnostics& diagnostics_;
  const std::vector<std::string> names_ = column_names();
  std::vector<std::size_t> columns_;  ///< Index in `names_` for each column of the file.
  MotionRecord record_;
  int complaints_ = 0;
};

}  // namespace

std::optional<MotionHistory> read_motion_history(const std::string& file, double heading, Diagnostics& diagnostics) {
  const std::optional<std::string> text = read_text_file(file, diagnostics);
  if (!text) return std::nullopt;
  std::optional<MotionRecord> record = HistoryReader(file, diagnostics).read(*text);
  if (!record) return std::nullopt;
  const int errors = diagnostics.error_count();
  check_motion_values(*record, diagnostics);
  if (diagnostics.error_count() > errors) return std::nullopt;
  unwrap_angles(*record);
  check_motion_record(*record, heading, diagnostics);
  return std::move(record->history);
}

}  // namespace overbend
