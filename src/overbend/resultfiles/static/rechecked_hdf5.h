/// A results.h5 of a dynamic analysis with repeated code checks.
#pragma once

#include <filesystem>

#include "model/description/description.h"
#include "results/dynamic_results.h"

namespace overbend {

/// Copies the file `from` to `to` with the checks, the design values, the assumptions and the model's text of these
/// results in place of the stored ones. Histories, impacts and snapshots are not read. Throws FileError if the file
/// cannot be written.
void copy_rechecked(const std::filesystem::path& from, const std::filesystem::path& to, const StaticResults& statics,
                    const DynamicResults& dynamics, const Description& description);

}  // namespace overbend
