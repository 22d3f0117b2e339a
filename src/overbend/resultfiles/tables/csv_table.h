/// Text tables for spreadsheets.
#pragma once

#include <fmt/format.h>

#include <cmath>
#include <string>
#include <vector>

namespace overbend {

/// Rows by RFC 4180: commas, CR LF, quotes where a text needs them; twelve digits.
class CsvTable {
 public:
  explicit CsvTable(const std::vector<std::string>& names) {
    for (const std::string& name : names) cell(name);
    end_row();
  }
  CsvTable& cell(const std::string& text) {
    if (!row_start_) text_ += ',';
    row_start_ = false;
    if (text.find_first_of(",\"\r\n") == std::string::npos) {
      text_ += text;
      return *this;
    }
    text_ += '"';
    for (const char c : text) text_ += (c == '"') ? std::string("\"\"") : std::string(1, c);
    text_ += '"';
    return *this;
  }
  /// NaN is a missing value: an empty cell.
  CsvTable& cell(double value) {
    return cell(std::isnan(value) ? std::string() : fmt::format("{:.12g}", value == 0.0 ? 0.0 : value));
  }
  void end_row() {
    text_ += "\r\n";
    row_start_ = true;
  }
  const std::string& text() const { return text_; }

 private:
  std::string text_;
  bool row_start_ = true;
};

}  // namespace overbend
