/// Text of the results of several seeds for the terminal.
#pragma once

#include <filesystem>

#include "app/exit_code.h"
#include "study/seeds/study.h"

namespace overbend {

/// Prints the statistics over the seeds, reports failed seeds on stderr and returns the exit code. `strict` as in
/// strict_code().
ExitCode report_seeds(const StudyOutcome& end, const std::filesystem::path& folder, bool strict);

}  // namespace overbend
