/// Reads results.h5 of lines by themselves.
#pragma once

#include <filesystem>
#include <string>

#include "results/line_results.h"

namespace overbend {

struct StoredLines {
  LinesResults results;    ///< The lines at rest; title, assumptions and what a run found are in summary.json.
  std::string model_text;  ///< As it was read.
};

/// Gives back the lines at rest that write_lines_files wrote, bit for bit. Throws std::runtime_error where the file is
/// none of ours or holds no lines.
StoredLines read_lines_results(const std::filesystem::path& h5);

}  // namespace overbend
