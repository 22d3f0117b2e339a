/// Command `static` for a model with an operation.
#pragma once

#include <filesystem>

#include "model/description/description.h"

namespace overbend {

/// Solves all stages, prints a line for each and writes a folder of results. Returns kNoSolution if no stage has an
/// equilibrium and, with `strict`, kCheckExceeded if a governing check of any stage is exceeded.
int run_static_operation(const Description& description, const std::filesystem::path& folder, bool strict);

}  // namespace overbend
