#include "seafiles/clock_text.h"

#include <fmt/format.h>

#include <cmath>

#include "base/text.h"

namespace overbend {
namespace {

constexpr double kDay = 86400.0;

/// Takes up to `digits` decimal digits from the front of the text; nothing without a digit.
std::optional<int> take_integer(std::string_view& text, std::size_t digits) {
  int value = 0;
  std::size_t count = 0;
  while (count < text.size() && count < digits && text[count] >= '0' && text[count] <= '9') {
    value = 10 * value + (text[count] - '0');
    ++count;
  }
  text.remove_prefix(count);
  return count > 0 ? std::optional(value) : std::nullopt;
}

bool take(std::string_view& text, char c) {
  if (text.empty() || text.front() != c) return false;
  text.remove_prefix(1);
  return true;
}

/// Days from 1970-01-01 in the proleptic Gregorian calendar. Source: Hinnant, chrono-compatible low-level date
/// algorithms, days_from_civil.
double days_from_date(int year, int month, int day) {
  const int shifted = month <= 2 ? year - 1 : year;
  const int era = shifted / 400;
  const int of_era = shifted - era * 400;
  const int of_year = (153 * (month + (month > 2 ? -3 : 9)) + 2) / 5 + day - 1;
  return era * 146097.0 + of_era * 365.0 + std::floor(of_era / 4.0) - std::floor(of_era / 100.0) + of_year - 719468.0;
}

/// Takes a date; nothing if it is invalid.
std::optional<double> take_date(std::string_view& text) {
  constexpr int kFirstYear = 1900, kLastYear = 2200;
  const auto first = take_integer(text, 4);
  if (!first || text.empty()) return std::nullopt;
  const char mark = text.front();
  if (mark != '-' && mark != '/' && mark != '.') return std::nullopt;
  take(text, mark);
  const auto second = take_integer(text, 2);
  if (!second || !take(text, mark)) return std::nullopt;
  const auto third = take_integer(text, 4);
  if (!third) return std::nullopt;
  const bool year_first = *first >= kFirstYear;
  if (!year_first && mark != '.') return std::nullopt;
  const int year = year_first ? *first : *third, day = year_first ? *third : *first;
  if (year < kFirstYear || year > kLastYear || *second < 1 || *second > 12 || day < 1 || day > 31) return std::nullopt;
  return days_from_date(year, *second, day);
}

/// Takes the distance from UTC [s], "Z", "+02:00" or "+0200"; 0 if there is none.
std::optional<double> zone_seconds(std::string_view text) {
  text = trim(text);
  if (text.empty() || text == "Z" || text == "z" || lower_case(text) == "utc") return 0.0;
  const double sign = text.front() == '-' ? -1.0 : 1.0;
  if (text.front() != '+' && text.front() != '-') return std::nullopt;
  text.remove_prefix(1);
  const auto hours = take_integer(text, 2);
  take(text, ':');
  const auto minutes = text.empty() ? std::optional(0) : take_integer(text, 2);
  if (!hours || !minutes || !text.empty() || *hours > 14 || *minutes > 59) return std::nullopt;
  return sign * (3600.0 * *hours + 60.0 * *minutes);
}

/// Takes a clock time from the front of the text.
std::optional<double> take_clock(std::string_view& text) {
  const auto hours = take_integer(text, 4);
  if (!hours || !take(text, ':')) return std::nullopt;
  const auto minutes = take_integer(text, 2);
  if (!minutes || *minutes > 59 || !take(text, ':')) return std::nullopt;
  const auto seconds = take_integer(text, 2);
  if (!seconds || *seconds > 60) return std::nullopt;
  double fraction = 0.0;
  if (take(text, '.') || take(text, ',')) {
    double place = 1.0;
    while (!text.empty() && text.front() >= '0' && text.front() <= '9') {
      place *= 10.0;
      // digits beyond the ninth are below a nanosecond
      if (place <= 1e9) fraction = 10.0 * fraction + (text.front() - '0');
      text.remove_prefix(1);
    }
    fraction /= std::min(place, 1e9);
  }
  return 3600.0 * *hours + 60.0 * *minutes + *seconds + fraction;
}

}  // namespace

std::optional<double> parse_clock(std::string_view text) {
  const std::optional<double> seconds = take_clock(text);
  return text.empty() ? seconds : std::nullopt;
}

std::optional<DateTime> parse_date_time(std::string_view text) {
  const std::optional<double> day = take_date(text);
  if (!day || !(take(text, 'T') || take(text, ' ') || take(text, 't'))) return std::nullopt;
  text = trim(text);
  const std::optional<double> clock = take_clock(text);
  const std::optional<double> zone = clock ? zone_seconds(text) : std::nullopt;
  if (!zone || *clock > kDay) return std::nullopt;
  return DateTime{*day, *clock - *zone};
}

std::string unix_time_label(double seconds) {
  const double day = std::floor(seconds / kDay);
  const auto within = static_cast<int>(seconds - day * kDay);
  int year = 1970;
  while (year < 9999 && days_from_date(year + 1, 1, 1) <= day) ++year;
  int month = 1;
  while (month < 12 && days_from_date(year, month + 1, 1) <= day) ++month;
  return fmt::format("{}-{:02}-{:02} {:02}:{:02}:{:02} UTC", year, month,
                     1 + static_cast<int>(day - days_from_date(year, month, 1)), within / 3600, within / 60 % 60,
                     within % 60);
}

}  // namespace overbend
