/// Files in the layouts of surveys, instruments and spreadsheets, and damaged copies of them.
#pragma once

#include <cstdlib>
#include <fstream>
#include <functional>
#include <iterator>
#include <random>
#include <string>
#include <vector>

#include "base/diagnostics.h"

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

/// Calls `read` with copies of a text that have up to three bytes changed, parts cut out, and lines lost or doubled.
inline void with_damage(const std::string& good, int trials, const std::function<void(const std::string&)>& read) {
  const std::string bytes = "0129.,;:-+eE\t \n\"#%/nai\0\xff";
  std::mt19937 random(20090301);
  const auto below = [&](std::size_t n) { return random() % n; };
  const auto line_start = [](const std::string& text, std::size_t from) {
    const std::size_t end = from == 0 ? std::string::npos : text.rfind('\n', from - 1);
    return end == std::string::npos ? 0 : end + 1;
  };
  for (int trial = 0; trial < trials; ++trial) {
    std::string text = good;
    for (std::size_t change = 1 + below(3); change > 0 && !text.empty(); --change) {
      // errors in the first lines are the most varied
      const std::size_t index = below(2) == 0 ? below(text.size()) : below(std::min<std::size_t>(text.size(), 200));
      const std::size_t start = line_start(text, index), end = std::min(text.find('\n', index), text.size() - 1) + 1;
      switch (below(5)) {
        case 0:
          text[index] = bytes[below(bytes.size())];
          break;
        case 1:
          text.erase(index, 1 + below(20));
          break;
        case 2:
          text.erase(start, end - start);
          break;
        case 3:
          text.insert(start, text.substr(start, end - start));
          break;
        default:
          text.resize(index);
          break;
      }
    }
    read(text);
  }
}

/// Number of damaged copies per file in a test; OVERBEND_FUZZ_TRIALS replaces it for a long search by hand.
inline int damage_trials() {
  const char* given = std::getenv("OVERBEND_FUZZ_TRIALS");
  return given != nullptr ? std::atoi(given) : 150;
}

}  // namespace overbend::testing
