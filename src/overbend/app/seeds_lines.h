/// What several seeds gave, on the command line.
#pragma once

#include <filesystem>

#include "app/exit_code.h"
#include "study/seeds/study.h"

namespace overbend {

/// Prints the values over the seeds and tells on stderr of those that failed; the exit code. `strict`: as
/// strict_code().
ExitCode tell_seeds(const StudyEnd& end, const std::filesystem::path& folder, bool strict);

}  // namespace overbend
