/// Mooring lines without mass and drag in time: elastic catenaries that follow their fairleads at once.
#pragma once

#include "mechanics/winch.h"
#include "moorings/spread.h"
#include "system/free_body.h"

namespace overbend {

/// The lines of `spread` that are there, from their fairleads on the body to their anchors, with the lengths they have.
/// `programs`: of the winches, in the order of the spread; empty: all hold. Of a table changes alone count. Where a
/// line has no shape its force is not a number: the step that asked for it is of no use.
std::vector<BodySpring> quasi_static_lines(const MooringSpread& spread, const std::vector<LengthTable>& programs);

}  // namespace overbend
