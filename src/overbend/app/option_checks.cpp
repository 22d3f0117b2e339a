#include "app/option_checks.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>

#include "base/ranges.h"
#include "base/text.h"
#include "base/units.h"

namespace overbend {
namespace {

std::string found(const std::string& text, const std::string& expected) {
  return fmt::format("found '{}', expected {}", for_display(text), expected);
}

}  // namespace

CLI::Validator one_of_choices(const std::vector<std::string>& choices) {
  const auto check = [choices](const std::string& text) -> std::string {
    if (ranges::find(choices, text) != choices.end()) return "";
    const std::string near = nearest_word(text, choices);
    return found(text, join_items(choices, "or")) + (near.empty() ? "" : "; did you mean '" + near + "'?");
  };
  return {check, "{" + CLI::detail::join(choices, ",") + "}"};
}

CLI::Validator whole_number(int low, int high) {
  const auto check = [low, high](const std::string& text) -> std::string {
    int number = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    const bool complete = error == std::errc() && end == text.data() + text.size();
    if (complete && number >= low && number <= high) return "";
    return found(text, fmt::format("a whole number from {} to {}", low, high));
  };
  return {check, fmt::format("{} to {}", low, high)};
}

CLI::Validator seconds() {
  const auto check = [](const std::string& text) -> std::string {
    const std::optional<double> number = parse_number(text);
    return number && std::isfinite(*number) && *number >= 0.0
               ? ""
               : found(text, "a number of seconds of at least 0, without unit");
  };
  return {check, "SECONDS"};
}

}  // namespace overbend
