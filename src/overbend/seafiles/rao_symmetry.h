/// Headings that a table of RAOs lacks, by the symmetry of the vessel.
#pragma once

#include "model/waves/rao_table.h"
#include "seafiles/rao_convention.h"

namespace overbend {

/// Adds the mirror image at midship (fore_aft, quarters), or turns the one heading of a circular vessel all round. The
/// other side of the vessel is left to RaoTable::one_sided.
void complete_by_symmetry(RaoTable& table, RaoSymmetry symmetry);

}  // namespace overbend
