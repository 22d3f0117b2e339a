/// Error in a file of hull data; the first one ends the reading.
#pragma once

#include <optional>
#include <stdexcept>
#include <string>
#include <utility>

#include "base/diagnostics.h"

namespace overbend {

/// Thrown inside the readers of hull files, and reported by add_error.
struct HullFileError : std::runtime_error {
  HullFileError(std::string found_, std::string expected_, std::string hint_ = {})
      : std::runtime_error(found_), found(std::move(found_)), expected(std::move(expected_)), hint(std::move(hint_)) {}
  HullFileError(int line_, std::string found_, std::string expected_, std::string hint_ = {})
      : HullFileError(std::move(found_), std::move(expected_), std::move(hint_)) {
    line = line_;
  }
  /// For readers of several files.
  HullFileError in_file(std::string name) const {
    HullFileError copy = *this;
    if (copy.file.empty()) copy.file = std::move(name);
    return copy;
  }

  std::string found, expected, hint;
  std::string file;  ///< Empty: the file that the reader was asked for.
  int line = 0;      ///< 0: no line.
};

/// Adds the error to `diagnostics`; `file` is the file that the reader was asked for.
inline void add_error(const HullFileError& error, const std::string& file, Diagnostics& diagnostics) {
  diagnostics.add({Severity::error, error.file.empty() ? file : error.file, error.line, 0, "", error.found,
                   error.expected, error.hint});
}

}  // namespace overbend
