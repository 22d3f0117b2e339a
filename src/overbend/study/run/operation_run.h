/// An operation on the line into one folder.
#pragma once

#include <filesystem>

#include "model/description/description.h"
#include "results/operation_results.h"

namespace overbend {

/// Writes the files of an operation and its report, whole or not at all. Throws UnusableFolder
/// (runstore/staged_folder.h) when the folder cannot be.
void write_operation_run(const OperationResults& results, const Description& description,
                         const std::filesystem::path& folder);

}  // namespace overbend
