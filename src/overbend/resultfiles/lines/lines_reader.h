/// Reads the results of lines by themselves back.
#pragma once

#include <filesystem>
#include <string>

#include "results/line_results.h"

namespace overbend {

struct StoredLines {
  LinesResults results;
  std::string model_text;
  std::string model_file;  ///< Its path as it was given.
};

/// Whether results.h5 is one of lines by themselves.
bool has_lines(const std::filesystem::path& h5);

/// Gives back what write_lines_files wrote, bit for bit. Throws std::runtime_error that says what is missing where the
/// file is none of ours.
StoredLines read_lines_results(const std::filesystem::path& h5);

}  // namespace overbend
