#include "seafiles/column_title.h"

#include <array>

#include "base/ranges.h"
#include "base/text.h"
#include "base/units.h"

namespace overbend {
namespace {

constexpr std::size_t kMaxUnitLength = 24;

/// Units that may follow an underscore; others, such as "a", may be part of a name.
bool is_suffix_unit(std::string_view text) {
  constexpr std::array<std::string_view, 12> kUnits = {"m",   "mm", "cm", "km",  "ft", "deg",
                                                       "rad", "s",  "ms", "min", "h",  "degrees"};
  return ranges::find(kUnits, text) != kUnits.end();
}

bool is_title_unit(std::string_view text) {
  for (const char* si_unit : {"m", "rad", "s"}) {
    if (title_unit_factor(text, si_unit)) return true;
  }
  return false;
}

/// Removes a pair of brackets around the text.
std::string_view without_brackets(std::string_view text) {
  if (text.size() < 2) return text;
  const bool pair = (text.front() == '[' && text.back() == ']') || (text.front() == '(' && text.back() == ')');
  return pair ? trim(text.substr(1, text.size() - 2)) : text;
}

}  // namespace

std::optional<double> title_unit_factor(std::string_view unit, const std::string& si_unit) {
  if (unit.empty() || unit.size() > kMaxUnitLength) return std::nullopt;
  if (unit == "\xc2\xb0" || unit == "\xb0") unit = "deg";  // the degree sign in UTF-8 and Latin-1
  const std::string word = lower_case(unit);
  if (word == "seconds" || word == "sec" || word == "secs") unit = "s";
  const std::optional<double> factor = unit_factor(std::string(unit), si_unit);
  return factor || word == unit ? factor : unit_factor(word, si_unit);
}

bool is_unix_title(const ColumnTitle& title) {
  return title.remark.find("unix") != std::string::npos || title.name == "unix";
}

bool is_time_title(const ColumnTitle& title) {
  constexpr std::array<std::string_view, 7> kNames = {"time",      "t",     "timestamp", "datetime",
                                                      "date_time", "clock", "date time"};
  return is_unix_title(title) || ranges::find(kNames, title.name) != kNames.end();
}

std::string bare_unit(std::string_view cell) {
  return std::string(without_brackets(trim(cell)));
}

bool is_unit_cell(std::string_view cell) {
  const std::string_view unit = without_brackets(trim(cell));
  if (unit == "-" || unit == "%" || is_title_unit(unit)) return true;
  const std::string pattern = lower_case(unit);
  return pattern.starts_with("hh:mm") || pattern.starts_with("yyyy") || pattern.starts_with("dd") || pattern == "utc" ||
         unit_factor(std::string(unit.substr(0, kMaxUnitLength)), "1/s").has_value() ||
         unit_factor(std::string(unit.substr(0, kMaxUnitLength)), "m/s").has_value();
}

ColumnTitle parse_column_title(std::string_view title) {
  ColumnTitle result;
  title = trim(title);
  const std::size_t open = title.find_last_of("[(");
  if (open != std::string_view::npos && open > 0 && !title.empty() && (title.back() == ']' || title.back() == ')')) {
    std::string_view inside = trim(title.substr(open + 1, title.size() - open - 2));
    const std::size_t comma = inside.find_last_of(',');
    if (comma != std::string_view::npos) {
      result.remark = lower_case(trim(inside.substr(0, comma)));
      inside = trim(inside.substr(comma + 1));
    }
    result.unit = std::string(inside);
    result.name = lower_case(trim(title.substr(0, open)));
    return result;
  }
  const std::size_t comma = title.find_last_of(','), underscore = title.find_last_of('_');
  if (comma != std::string_view::npos && is_title_unit(trim(title.substr(comma + 1)))) {
    return {lower_case(trim(title.substr(0, comma))), std::string(trim(title.substr(comma + 1))), ""};
  }
  if (underscore != std::string_view::npos && underscore > 0) {
    const std::string suffix = lower_case(title.substr(underscore + 1));
    if (is_suffix_unit(suffix)) return {lower_case(title.substr(0, underscore)), suffix, ""};
  }
  result.name = lower_case(title);
  return result;
}

}  // namespace overbend
