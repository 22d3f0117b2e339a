/// From single records of an RAO file to the table.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/diagnostics.h"
#include "model/rao_table.h"
#include "seafiles/rao_convention.h"

namespace overbend {

/// Sorts records into a table of all headings and frequencies. Every degree of freedom in the file must be given once
/// for each pair (headings 0 and 360 deg may both be given if they agree); others are zero and become an assumption. A
/// file of the starboard side alone (180 to 360 deg) is mirrored. Points are left to the caller. Faults go to
/// `diagnostics`, and nothing is returned.
std::optional<RaoTable> assemble_raos(const std::vector<RaoRecord>& records, const RaoTranslation& translation,
                                      const std::string& file, Diagnostics& diagnostics);

}  // namespace overbend
