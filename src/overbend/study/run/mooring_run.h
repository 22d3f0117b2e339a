/// Statics of a moored hull into one folder.
#pragma once

#include <filesystem>

#include "model/description/description.h"
#include "results/mooring_results.h"

namespace overbend {

/// Writes the files of a static analysis of hull and moorings, whole or not at all. Throws UnusableFolder
/// (runstore/staged_folder.h) when the folder cannot be.
void write_mooring_run(const MooringResults& results, const Description& description,
                       const std::filesystem::path& folder);

}  // namespace overbend
