/// Number files of WAMIT: rows of numbers, perhaps with a heading of free text.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "base/diagnostics.h"

namespace overbend::wamit {

constexpr std::size_t kMostColumns = 8;

struct Row {
  int line = 0;             ///< From 1.
  std::size_t columns = 0;  ///< As many as the line has.
  std::array<double, kMostColumns> values{};
};

struct Table {
  std::string file;
  std::vector<Row> rows;
};

/// Reads rows of `least` to `most` numbers; lines before the first that begins with a number are passed over. One error
/// for a bad file, and nothing is returned.
std::optional<Table> read_table(const std::string& file, std::size_t least, std::size_t most, Diagnostics& diagnostics);

/// Its first column.
std::vector<double> first_column(const Table& table);

/// A mode, 1 surge to 6 yaw, as index 0 to 5; -1 where the number is none.
int mode_index(double number);

}  // namespace overbend::wamit
