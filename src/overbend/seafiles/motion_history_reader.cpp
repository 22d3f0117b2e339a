#include "seafiles/motion_history_reader.h"

#include <algorithm>

#include "base/constants.h"
#include "base/text.h"
#include "base/units.h"
#include "seafiles/text_table.h"

namespace overbend {
namespace {

constexpr int kMostComplaints = 10;
const std::vector<std::string> kColumns = {"time_s",   "surge_m",   "sway_m", "heave_m",
                                           "roll_deg", "pitch_deg", "yaw_deg"};

class HistoryReader {
 public:
  HistoryReader(std::string file, Diagnostics& diagnostics) : file_(std::move(file)), diagnostics_(diagnostics) {}

  std::optional<MotionHistory> read(const std::string& text) {
    const TextTable table = split_table(text, ',');
    if (table.rows.empty()) {
      complain(0, "no rows", "a header such as time_s,surge_m,sway_m,heave_m,roll_deg,pitch_deg,yaw_deg and numbers");
      return std::nullopt;
    }
    read_header(table.rows.front());
    if (complaints_ > 0) return std::nullopt;
    for (std::size_t i = 1; i < table.rows.size() && complaints_ < kMostComplaints; ++i) read_row(table.rows[i]);
    if (complaints_ == 0 && history_.time.size() < 2) {
      complain(table.rows.back().line, std::to_string(history_.time.size()) + " instants", "at least two");
    }
    if (complaints_ > 0) return std::nullopt;
    tell_gap();
    history_.source = file_;
    return std::move(history_);
  }

 private:
  void complain(int line, const std::string& found, const std::string& expected) {
    ++complaints_;
    diagnostics_.add({Severity::error, file_, line, 0, "", found, expected, ""});
  }

  void read_header(const TextRow& header) {
    for (const std::string_view cell : header.cells) {
      const auto known = std::find(kColumns.begin(), kColumns.end(), cell);
      if (known == kColumns.end()) {
        complain(header.line, "a column '" + for_display(cell) + "'", one_of(kColumns));
        return;
      }
      const auto column = static_cast<std::size_t>(known - kColumns.begin());
      if (std::find(columns_.begin(), columns_.end(), column) != columns_.end()) {
        complain(header.line, "the column '" + *known + "' a second time", "it once");
      }
      columns_.push_back(column);
    }
    if (std::find(columns_.begin(), columns_.end(), 0U) == columns_.end()) {
      complain(header.line, "a header without time_s", "time_s and the degrees of freedom that move");
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
        complain(row.line, "'" + for_display(row.cells[i]) + "'", "a number for " + kColumns[columns_[i]]);
        return;
      }
      if (columns_[i] == 0) {
        time = *value;
      } else {
        freedoms[columns_[i] - 1] = columns_[i] > 3 ? *value * kDegree : *value;
      }
    }
    if (!history_.time.empty() && time <= history_.time.back()) {
      complain(row.line, "a time of " + for_display(row.cells[time_column()]) + " s", "more than in the row before");
      return;
    }
    history_.time.push_back(time);
    history_.freedoms.push_back(freedoms);
  }

  /// A record with a hole: the spline over it is not the vessel's motion.
  void tell_gap() {
    constexpr double kGap = 5.0;  // usual steps
    std::vector<double> steps;
    for (std::size_t i = 1; i < history_.time.size(); ++i) steps.push_back(history_.time[i] - history_.time[i - 1]);
    const auto widest = std::max_element(steps.begin(), steps.end());
    const double step = *widest, from = history_.time[static_cast<std::size_t>(widest - steps.begin())];
    const auto middle = steps.begin() + static_cast<std::ptrdiff_t>(steps.size() / 2);
    std::nth_element(steps.begin(), middle, steps.end());
    if (step < kGap * *middle) return;
    diagnostics_.add({Severity::warning, file_, 0, 0, "",
                      "a gap of " + format_number(step, 4) + " s after t = " + format_number(from, 6) + " s, in rows " +
                          format_number(*middle, 4) + " s apart; the motion in it is a cubic between its ends",
                      "", ""});
  }

  std::size_t time_column() const {
    return static_cast<std::size_t>(std::find(columns_.begin(), columns_.end(), 0U) - columns_.begin());
  }

  std::string file_;
  Diagnostics& diagnostics_;
  std::vector<std::size_t> columns_;  ///< Place in kColumns of each column of the file.
  MotionHistory history_;
  int complaints_ = 0;
};

}  // namespace

std::optional<MotionHistory> read_motion_history(const std::string& file, Diagnostics& diagnostics) {
  const std::optional<std::string> text = read_text_file(file, diagnostics);
  return text ? HistoryReader(file, diagnostics).read(*text) : std::nullopt;
}

}  // namespace overbend
