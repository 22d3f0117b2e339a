/// Assembles records of an RAO file into a table.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/diagnostics.h"
#include "model/waves/rao_table.h"
#include "seafiles/rao_convention.h"
#include "seafiles/rao_formats.h"

namespace overbend {

/// Sorts records into a table of all headings and frequencies. Every degree of freedom in the file must be given once
/// for each pair (headings 0 and 360 deg may both be given if they agree); others are zero, recorded as an assumption.
/// Headings are completed by the symmetry stated in the file; a file with only the starboard side (180 to 360 deg) is
/// mirrored. The caller sets the reference points. Errors go to `diagnostics`, and nothing is returned.
std::optional<RaoTable> assemble_raos(const rao_formats::RaoFile& content, const RaoTranslation& translation,
                                      const std::string& file, Diagnostics& diagnostics);

}  // namespace overbend
