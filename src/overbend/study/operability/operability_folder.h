/// Limits of a study in its folder, computed from its records.
#pragma once

#include <filesystem>
#include <optional>

#include "study/operability/operability_study.h"

namespace overbend {

/// Writes the file operability.json. Throws FileError if the disk fails.
void write_operability(const OperabilityResults& results, const std::filesystem::path& folder);

/// Empty if there is no file.
std::optional<OperabilityResults> read_operability(const std::filesystem::path& folder);

/// Rewrites operability.json from the records if the study in the folder searches for limits: its study file is read at
/// its original path. Throws std::runtime_error if that cannot be read.
void refresh_operability(const std::filesystem::path& folder);

}  // namespace overbend
