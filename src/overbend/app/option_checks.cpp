#include "app/option_checks.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>

#include "base/text.h"
#include "base/units.h"

namespace overbend {
namespace {

std::string found(const std::string& text, const std::string& expected) {
  return fmt::format("found '{}', expected {}", for_display(text), expected);
}

}  // namespace

CLI::Validator one_of_words(const std::vector<std::string>& words) {
  const auto fault = [words](const std::string& text) -> std::string {
    if (std::ranges::find(words, text) != words.end()) return "";
    const std::string near = nearest_word(text, words);
    return found(text, join_words(words, "or")) + (near.empty() ? "" : "; did you mean '" + near + "'?");
  };
  return {fault, "{" + CLI::detail::join(words, ",") + "}"};
}

CLI::Validator whole_number(int low, int high) {
  const auto fault = [low, high](const std::string& text) -> std::string {
    int number = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    const bool whole = error == std::errc() && end == text.data() + text.size();
    if (whole && number >= low && number <= high) return "";
    return found(text, fmt::format("a whole number from {} to {}", low, high));
  };
  return {fault, fmt::format("{} to {}", low, high)};
}

CLI::Validator seconds() {
  const auto fault = [](const std::string& text) -> std::string {
    const std::optional<double> number = parse_number(text);
    return number && std::isfinite(*number) && *number >= 0.0 ? ""
                                                              : found(text, "seconds from 0 on, a number without unit");
  };
  return {fault, "SECONDS"};
}

}  // namespace overbend
