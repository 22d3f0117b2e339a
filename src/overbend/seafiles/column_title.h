/// Titles of table columns: a name and a unit, as "heave_m", "Heave [m]", "Heave (m)" or "Heave, m".
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace overbend {

struct ColumnTitle {
  std::string name;    ///< In lower case, without the unit.
  std::string unit;    ///< As written; empty if the title has none.
  std::string remark;  ///< Other text in brackets, in lower case: "unix" of "time (Unix, s)".
};

/// Splits a title into name and unit. A unit after an underscore or a comma counts only if it is a unit of length,
/// angle or time; text in brackets always does.
ColumnTitle parse_column_title(std::string_view title);

/// Returns true if the title is that of a column of times: "time", "t", "timestamp", "DATETIME", "clock".
bool is_time_title(const ColumnTitle& title);

/// Returns true if the title says that its times are Unix times: "unix", "Time (Unix, s)".
bool is_unix_title(const ColumnTitle& title);

/// Returns true for a unit alone in a cell, with or without brackets: "m", "[deg]", "-", or the pattern of a date.
bool is_unit_cell(std::string_view cell);

/// Returns a cell of a line of units without brackets.
std::string bare_unit(std::string_view cell);

/// Returns the value of one `unit`, as titles write it, in `si_unit`; nothing if it is not a unit of this dimension.
std::optional<double> title_unit_factor(std::string_view unit, const std::string& si_unit);

}  // namespace overbend
