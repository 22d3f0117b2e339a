/// The limits of a study in its folder, from its records.
#pragma once

#include <filesystem>
#include <optional>

#include "study/operability/operability_study.h"

namespace overbend {

/// The file operability.json. Throws FileFault where the disk refuses.
void write_operability(const OperabilityResults& results, const std::filesystem::path& folder);

/// Nothing where there is none.
std::optional<OperabilityResults> read_operability(const std::filesystem::path& folder);

/// Makes operability.json anew from the records, if the study in the folder looks for limits: its study file is read
/// where it was. Throws std::runtime_error where that cannot be read any more.
void refresh_operability(const std::filesystem::path& folder);

}  // namespace overbend
