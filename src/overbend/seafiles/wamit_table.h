/// Numeric files of WAMIT: rows of numbers, optionally after lines of free text.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "base/diagnostics.h"

namespace overbend::wamit {

constexpr std::size_t kMaxColumns = 8;

struct Row {
  int line = 0;             ///< From 1.
  std::size_t columns = 0;  ///< Number of columns of the line.
  std::array<double, kMaxColumns> values{};
};

struct Table {
  std::string file;
  std::vector<Row> rows;
};

/// Reads rows of `min_columns` to `max_columns` numbers; lines before the first one that begins with a number are
/// skipped. A bad file gives one error, and nothing is returned.
std::optional<Table> read_table(const std::string& file, std::size_t min_columns, std::size_t max_columns,
                                Diagnostics& diagnostics);

/// Returns the values of the first column.
std::vector<double> first_column(const Table& table);

/// Returns the index 0 (surge) to 5 (yaw) of a mode from 1 to 6; -1 for another number. With `body`, modes from 7 on
/// are those of the following bodies: returns kOtherBody for those of another one.
int mode_index(double number, const std::optional<int>& body);
inline constexpr int kOtherBody = -2;
inline constexpr const char* kBodyHint = "vessel.motion.coupled.convention.body selects one of several bodies";

}  // namespace overbend::wamit
