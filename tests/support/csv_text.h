/// Reads tables of results as a spreadsheet would.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace overbend::testing {

/// Lines without their CR LF; a line that ends otherwise is a failure.
inline std::vector<std::string> csv_lines(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) {
    EXPECT_TRUE(!line.empty() && line.back() == '\r');
    line.pop_back();
    lines.push_back(line);
  }
  return lines;
}

inline std::vector<std::string> csv_cells(const std::string& line) {
  std::vector<std::string> cells;
  std::istringstream stream(line + ",");
  for (std::string cell; std::getline(stream, cell, ',');) cells.push_back(cell);
  return cells;
}

inline double value_in(const std::vector<std::string>& lines, std::size_t row, const std::string& column) {
  const std::vector<std::string> names = csv_cells(lines.at(0));
  const auto found = std::find(names.begin(), names.end(), column);
  if (found == names.end()) throw std::runtime_error("no column " + column);
  return std::stod(csv_cells(lines.at(row)).at(static_cast<std::size_t>(found - names.begin())));
}

}  // namespace overbend::testing
