/// Random damage to the text of a file, for tests of readers.
#pragma once

#include <algorithm>
#include <cstdlib>
#include <iterator>
#include <random>
#include <string>

namespace overbend::testing {

/// Returns the text with one random damage: a byte changed, characters lost, a cut, a line lost or doubled, or
/// something else in place of a number. The first lines, whose errors are the most varied, are damaged more often.
inline std::string damaged_text(std::string text, std::mt19937& random) {
  const auto below = [&](std::size_t n) { return n == 0 ? 0 : random() % n; };
  const std::size_t head = std::min<std::size_t>(text.size(), 200);
  const std::size_t place = below(3) == 0 ? below(head) : below(text.size());
  const std::size_t begin = text.rfind('\n', place) == std::string::npos ? 0 : text.rfind('\n', place) + 1;
  const std::size_t end = std::min(text.find('\n', place), std::max<std::size_t>(text.size(), 1) - 1) + 1;
  constexpr const char* kInserted[] = {"nan", "inf",  "-1", "1e308", "*****", "99999999999", "",
                                       "0",   "\xff", "\"", ",",     ";",     "\t",          "MM"};
  switch (text.empty() ? 5 : below(6)) {
    case 0:
      text[place] = static_cast<char>(below(256));
      break;
    case 1:
      text.erase(place, 1 + below(20));
      break;
    case 2:
      text.resize(place);
      break;
    case 3:
      text.erase(begin, end - begin);
      break;
    case 4:
      text.insert(begin, text.substr(begin, end - begin));
      break;
    default:
      text.replace(place, below(8), kInserted[below(std::size(kInserted))]);
  }
  return text;
}

/// Number of damaged copies per file in a test; OVERBEND_FUZZ_TRIALS replaces it for a long search by hand.
inline int damage_trials() {
  const char* given = std::getenv("OVERBEND_FUZZ_TRIALS");
  return given != nullptr ? std::max(1, std::atoi(given)) : 150;
}

}  // namespace overbend::testing
