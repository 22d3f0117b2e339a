/// From single records of an RAO file to the table.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/diagnostics.h"
#include "model/rao_table.h"
#include "seafiles/rao_convention.h"

namespace overbend {

/// Sorts records into a table of all headings and frequencies. Every freedom that the file gives must stand there for
/// each pair of both, once (headings 0 and 360 deg may both stand if they agree); freedoms it does not give are zero
/// and become an assumption. A file of the starboard side alone (180 to 360 deg) is mirrored. Points are left to the
/// caller. Faults go to `diagnostics`, and nothing is returned.
std::optional<RaoTable> assemble_raos(const std::vector<RaoRecord>& records, const RaoTranslation& translation,
                                      const std::string& file, Diagnostics& diagnostics);

}  // namespace overbend
