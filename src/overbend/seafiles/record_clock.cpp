#include "seafiles/record_clock.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/text.h"
#include "base/units.h"
#include "seafiles/clock_text.h"
#include "seafiles/column_title.h"
#include "seafiles/record_statistics.h"
#include "seafiles/table_layout.h"
#include "seafiles/text_table.h"

namespace overbend {
namespace {

constexpr double kDay = 86400.0, kNewDay = 23.0 * 3600.0;         // [s]
constexpr double kFirstUnixTime = 1e9, kLastUnixTime = 4.1025e9;  ///< Years 2001 and 2100 [s].
constexpr const char* kAllDigits = "times with all their digits: a spreadsheet may have shortened them";

/// Value of the last digit of a number in exponent form, "1.780301E+09"; 0 for other numbers, which have all digits.
double last_digit(std::string_view cell) {
  const std::size_t exponent = cell.find_first_of("eE");
  if (exponent == std::string_view::npos) return 0.0;
  const std::size_t point = cell.find('.');
  const double decimals = point < exponent ? static_cast<double>(exponent - point - 1) : 0.0;
  const std::optional<double> power = cell_number(cell.substr(exponent + 1));
  return power ? std::pow(10.0, std::clamp(*power - decimals, -300.0, 300.0)) : 0.0;
}

}  // namespace

RecordClock::RecordClock(const std::string& path, std::string unit, bool is_unix, Diagnostics& diagnostics)
    : path_(path), unit_(std::move(unit)), is_unix_(is_unix), diagnostics_(diagnostics) {}

std::optional<double> RecordClock::reject(int line, std::string found, std::string expected, std::string hint) {
  diagnostics_.add({Severity::error, path_, line, 0, "", std::move(found), std::move(expected), std::move(hint)});
  return std::nullopt;
}

/// Decides from the first row which kind of time the column holds.
bool RecordClock::recognise(int line, std::string_view cell) {
  const std::optional<double> factor = title_unit_factor(unit_, "s");
  if (const std::optional<double> number = cell_number(cell)) {
    kind_ = Kind::number;
    factor_ = factor.value_or(1.0);
    const auto is_unix = [](double seconds) { return seconds >= kFirstUnixTime && seconds < kLastUnixTime; };
    if (is_unix(factor_ * *number)) kind_ = Kind::unix_time;
    if (!factor && is_unix(1e-3 * *number)) {
      kind_ = Kind::unix_time;
      factor_ = 1e-3;
    }
    if (kind_ == Kind::unix_time || (factor && !is_unix_)) return true;
    reject(line,
           is_unix_ ? "a Unix time of '" + for_display(cell) + "'"
                    : "a time of '" + for_display(cell) + "' without a unit",
           is_unix_ ? "seconds or milliseconds since 1970, of the years 2001 to 2100"
                    : "the unit of time in the header, in a line of units or in columns, such as time_s or 'time, ms'");
    return false;
  }
  if (parse_clock(cell)) kind_ = Kind::clock;
  if (parse_date_time(cell)) kind_ = Kind::date;
  if (kind_ != Kind::unknown) return true;
  const bool minutes = std::count(cell.begin(), cell.end(), ':') == 1;
  const bool date = cell.find('/') != std::string_view::npos;
  reject(line, "'" + for_display(cell) + "'",
         factor ? "a number for time_" + unit_
                : "a number, a clock time such as 23:59:40.5 or a date with time, 2026-06-01T09:00:00",
         date      ? "days and months between slashes are ambiguous: write the year first"
         : minutes ? "write times with hours, minutes and seconds"
                   : "");
  return false;
}

std::optional<double> RecordClock::parse_number(int line, std::string_view cell) {
  const std::optional<double> number = cell_number(cell);
  if (!number) return reject(line, "'" + for_display(cell) + "'", "a number for the time");
  resolution_ = std::max(resolution_, factor_ * last_digit(cell));
  const double seconds = factor_ * *number;
  if (!last_ && kind_ == Kind::unix_time) origin_ = seconds;
  return seconds - origin_;
}

std::optional<double> RecordClock::parse(int line, std::string_view cell) {
  if (kind_ == Kind::number || kind_ == Kind::unix_time) return parse_number(line, cell);
  if (kind_ == Kind::date) {
    const std::optional<DateTime> time = parse_date_time(cell);
    if (!time) return reject(line, "'" + for_display(cell) + "'", "a date with time, as in the first row");
    if (!last_) {
      first_day_ = time->day;
      origin_ = time->seconds;
    }
    return (time->day - first_day_) * kDay + (time->seconds - origin_);
  }
  const std::optional<double> clock = parse_clock(cell);
  if (!clock) return reject(line, "'" + for_display(cell) + "'", "a clock time, as in the first row");
  if (!clock_) origin_ = *clock;
  if (clock_ && *clock_ - *clock >= kNewDay) days_ += 1.0;
  clock_ = clock;
  return days_ * kDay + (*clock - origin_);
}

std::optional<double> RecordClock::reject_order(int line, std::string_view cell, double time) {
  const std::string text = for_display(cell);
  const char* expected = "a later time than in the previous row";
  if (time == *last_) return reject(line, text + " twice", expected, kAllDigits);
  return reject(line, text + " after " + last_cell_, expected,
                kind_ == Kind::clock
                    ? "only a clock that goes back by 23 h or more starts a new day; for a change of the "
                      "clock, such as daylight saving, give times with dates and their distance from UTC"
                    : "");
}

std::optional<double> RecordClock::read(int line, std::string_view cell) {
  if (kind_ == Kind::unknown && !recognise(line, cell)) return std::nullopt;
  const std::optional<double> time = parse(line, cell);
  if (!time) return std::nullopt;
  if (last_ && *time <= *last_) return reject_order(line, cell, *time);
  if (!last_) first_cell_ = for_display(cell);
  last_ = time;
  last_cell_ = for_display(cell);
  lines_.push_back(line);
  return time;
}

std::string RecordClock::description() const {
  switch (kind_) {
    case Kind::clock: {
      const std::string later = days_ > 1.0   ? fmt::format(" {:.0f} days later", days_)
                                : days_ > 0.0 ? " of the next day"
                                              : "";
      return "clock times, " + first_cell_ + " to " + last_cell_ + later;
    }
    case Kind::date:
      return "dates with times, " + first_cell_ + " to " + last_cell_;
    case Kind::unix_time:
      return "Unix times from " + unix_time_label(origin_);
    default:
      return "times from " + first_cell_ + (unit_.empty() ? "" : " " + unit_);
  }
}

bool RecordClock::finish(std::vector<double>& times) {
  if (times.size() < 2) return true;
  const std::vector<double> steps = differences(times);
  const double usual = median(steps);
  const auto [min_step, max_step] = std::minmax_element(steps.begin(), steps.end());
  constexpr double kCoarse = 0.2, kUneven = 1.5;
  if (resolution_ > kCoarse * usual && *max_step > kUneven * *min_step) {
    const auto row = static_cast<std::size_t>(max_step - steps.begin()) + 1;
    reject(lines_[row],
           fmt::format("times rounded to {:g} s, in steps of {:g} s to {:g} s", resolution_, *min_step, *max_step),
           "even steps", kAllDigits);
    return false;
  }
  const bool moved = kind_ == Kind::number && times.front() > 0.0;
  if (kind_ != Kind::number || moved) add_notice(diagnostics_, path_, 0, description() + "; t = 0 is the first row");
  if (moved) {
    const double start = times.front();
    for (double& time : times) time -= start;
  }
  return true;
}

}  // namespace overbend
