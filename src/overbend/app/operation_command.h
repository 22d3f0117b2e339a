/// The command static on a model with an operation on the line.
#pragma once

#include <filesystem>

#include "model/description/description.h"

namespace overbend {

/// All stages: a line for each on the terminal and a folder of results. kNoSolution where no stage has an equilibrium;
/// with `strict`, kCheckExceeded where a governing check of any stage is exceeded.
int run_static_operation(const Description& description, const std::filesystem::path& folder, bool strict);

}  // namespace overbend
