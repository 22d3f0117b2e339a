/// Text files of hull data: rows of cells, with numbers that are checked where they are read.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "base/vec.h"
#include "seafiles/hull_file_error.h"
#include "seafiles/text_table.h"

namespace overbend {

/// A text file in memory, split at white space. Throws HullFileError if it cannot be read.
class HullText {
 public:
  HullText(std::string text, std::string file);
  HullText(const HullText&) = delete;  // the rows refer to the text
  HullText& operator=(const HullText&) = delete;
  static HullText read(const std::string& file);

  const std::vector<TextRow>& rows() const { return table_.rows; }
  const std::string& file() const { return file_; }
  /// Line of the last row.
  int last_line() const { return table_.rows.empty() ? 0 : table_.rows.back().line; }

 private:
  std::string text_;
  TextTable table_;
  std::string file_;
};

/// Returns the name of a file without its folder.
std::string file_name(const std::string& path);

/// Returns the cells joined by single blanks, at most the first 40.
std::string joined(const TextRow& row);

/// True if the joined text of the row contains `part`.
bool contains(const TextRow& row, std::string_view part);

/// True if the first cell is a number.
bool begins_with_number(const TextRow& row);

/// Returns a cell as a number. Throws HullFileError with the text found; `expected` names the quantity.
double require_number(const TextRow& row, std::size_t cell, const std::string& expected);

/// Returns `count` numbers from the cell `first` on. Throws HullFileError.
std::vector<double> require_numbers(const TextRow& row, std::size_t first, std::size_t count,
                                    const std::string& expected);

/// Returns a point [m] from the cell `first` on. Throws HullFileError for coordinates of 10 km and more.
Vec3 require_point(const TextRow& row, std::size_t first, const std::string& expected);
/// Throws HullFileError for coordinates of 10 km and more, or that are not numbers.
void check_point(const Vec3& point, int line, const std::string& expected);

/// Returns all numbers of a row, ignoring cells that are not numbers.
std::vector<double> numbers_in(const TextRow& row);

/// Returns a whole number from `low` to `high`. Throws HullFileError.
int require_integer(const TextRow& row, std::size_t cell, int low, int high, const std::string& expected);

}  // namespace overbend
