/// Completes missing headings of an RAO table by the symmetry of the vessel.
#pragma once

#include "model/waves/rao_table.h"
#include "seafiles/rao_convention.h"

namespace overbend {

/// Adds the mirror image at midship (fore_aft, quarters), or rotates the single heading of a circular vessel around the
/// full circle. The other side of the vessel is handled by RaoTable::one_sided.
void complete_by_symmetry(RaoTable& table, RaoSymmetry symmetry);

}  // namespace overbend
