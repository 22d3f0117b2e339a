/// Massless mooring lines in dynamics: elastic catenaries that follow their fairleads instantly.
#pragma once

#include "mechanics/winch.h"
#include "moorings/mooring_spread.h"
#include "system/free_body.h"

namespace overbend {

/// Returns the intact lines of `spread`, from their fairleads on the body to their anchors, with their lengths there.
/// `programs`: of the winches, in the order of the spread; empty: constant lengths. Only changes of a table count.
/// Without a catenary solution the force is NaN: the step that requested it is invalid.
std::vector<BodySpring> quasi_static_lines(const MooringSpread& spread, const std::vector<LengthTable>& programs);

}  // namespace overbend
