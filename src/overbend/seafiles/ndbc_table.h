/// Rows and columns of NDBC text.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/diagnostics.h"
#include "seafiles/file_time.h"
#include "seafiles/text_table.h"

namespace overbend {

/// Numbers that stand for missing values in addition to MM: 999 in every column, 99 where it is no direction and no
/// moment.
enum class NdbcMissing { three_nines, two_or_three_nines };

/// Values over frequency of one time; missing ones are NaN.
struct NdbcSpectrumRow {
  int line = 0;
  std::vector<double> frequencies;  ///< Increasing, positive [Hz].
  std::vector<double> values;
};

/// Views into the source text, which must outlive the table.
struct NdbcTable {
  enum class Kind {
    sea_states,  ///< Named columns.
    table,       ///< A column per frequency.
    pairs        ///< Values with their frequencies in brackets.
  };
  Kind kind = Kind::sea_states;
  std::vector<std::string_view> columns;  ///< Names in the header.
  std::size_t date_columns = 5;
  std::vector<TextRow> rows;
  std::vector<FileTime> times;  ///< Times of the rows.

  bool has(std::string_view column) const;
  /// Returns a cell; empty if there is no such column.
  std::string_view cell(std::size_t row, std::string_view column) const;
  /// Returns the number in a cell; empty if it is missing.
  std::optional<double> value(std::size_t row, std::string_view column) const;
  /// Returns the values of a row of the kinds over frequency. Errors go to `diagnostics`.
  std::optional<NdbcSpectrumRow> spectrum_row(std::size_t row, NdbcMissing missing, const std::string& path,
                                              Diagnostics& diagnostics) const;
};

/// Returns true for a header of year, month, day and hour.
bool is_ndbc_header(std::string_view line);

/// Splits a file and parses the times of its rows. Errors go to `diagnostics`, and nothing is returned.
std::optional<NdbcTable> split_ndbc(std::string_view text, const std::string& path, Diagnostics& diagnostics);

}  // namespace overbend
