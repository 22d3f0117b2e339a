/// Time column of a record: seconds and other units, Unix times, clock times, dates with times.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/diagnostics.h"

namespace overbend {

/// Converts the time column of a record to seconds, row by row. The first row decides which kind of time it is.
///
/// - Numbers in the unit of the title. A record that starts after 0 is moved to start at 0.
/// - Numbers without a unit that are Unix times in seconds or milliseconds of the years 2001 to 2100.
/// - Clock times `23:59:40.5`. A clock that goes back by 23 h or more starts a new day; any other step back is an
/// error.
/// - Dates with times, `2026-06-01T09:00:00.5Z`, also with a blank, with slashes, or as `01.06.2026 09:00:00`.
///
/// In the last three, t = 0 is the first row.
class RecordClock {
 public:
  /// `unit` is the unit of the column, empty if it is not stated; `is_unix` is true if its title says that times are
  /// Unix times. References must outlive the object.
  RecordClock(const std::string& path, std::string unit, bool is_unix, Diagnostics& diagnostics);

  /// Returns the time of a row [s]; reports an error and returns nothing for a cell that is no time or not later than
  /// the one before it.
  std::optional<double> read(int line, std::string_view cell);

  /// True once a row has shown which kind of time it is.
  bool is_recognised() const { return kind_ != Kind::unknown; }

  /// Reports how the times were read. Moves `times` to start at 0 if they start later. Returns false after an error:
  /// times that were shortened so much that their steps are uneven.
  bool finish(std::vector<double>& times);

 private:
  enum class Kind { unknown, number, unix_time, clock, date };

  std::optional<double> parse(int line, std::string_view cell);
  std::optional<double> parse_number(int line, std::string_view cell);
  bool recognise(int line, std::string_view cell);
  std::optional<double> reject(int line, std::string found, std::string expected, std::string hint = {});
  std::optional<double> reject_order(int line, std::string_view cell, double time);
  std::string description() const;

  const std::string& path_;
  std::string unit_;
  bool is_unix_;
  Diagnostics& diagnostics_;
  Kind kind_ = Kind::unknown;
  double factor_ = 1.0;          ///< Seconds per unit of numbers.
  double origin_ = 0.0;          ///< Time of the first row of Unix times and clocks [s].
  double days_ = 0.0;            ///< Days since the first row of a clock.
  double first_day_ = 0.0;       ///< Day of the first row of dates.
  double resolution_ = 0.0;      ///< Coarsest last digit of numbers in exponent form [s].
  std::optional<double> clock_;  ///< Clock time of the row before [s].
  std::optional<double> last_;   ///< Time of the row before [s].
  std::string first_cell_, last_cell_;
  std::vector<int> lines_;
};

}  // namespace overbend
