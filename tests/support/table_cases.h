/// Files in the layouts of surveys, instruments and spreadsheets, and damaged copies of them.
#pragma once

#include <fstream>
#include <functional>
#include <iterator>
#include <random>
#include <string>

#include "base/diagnostics.h"
#include "support/damaged_text.h"

namespace overbend::testing {

inline std::string table_case(const std::string& name) {
  return std::string(OVERBEND_SOURCE_DIR) + "/validation/table_cases/" + name;
}

inline std::string case_text(const std::string& name) {
  std::ifstream file(table_case(name), std::ios::binary);
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

/// Errors and warnings in one text, for failure messages and searches.
inline std::string all_messages(const Diagnostics& diagnostics) {
  std::string text;
  for (const Severity severity : {Severity::error, Severity::warning}) {
    for (const std::string& line : diagnostics.lines(severity)) text += line + "\n";
  }
  return text;
}

/// Calls `read` with damaged copies of a text.
inline void with_damage(const std::string& good, int trials, const std::function<void(const std::string&)>& read) {
  std::mt19937 random(20090301);
  for (int trial = 0; trial < trials; ++trial) {
    std::string text = good;
    for (std::size_t change = 1 + random() % 3; change > 0; --change) text = damaged_text(std::move(text), random);
    read(text);
  }
}

}  // namespace overbend::testing
