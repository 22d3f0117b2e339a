/// Coefficients of current forces by direction.
#pragma once

#include <string>
#include <vector>

#include "base/diagnostics.h"
#include "model/description/hull_description.h"

namespace overbend {

/// CSV with the columns angle_deg,cx,cy,cz: angles increase and go round without a gap above 60 deg, or to 180 deg from
/// 0 for the other side to mirror (cy and cz change sign there). Remarks begin with '#'. Errors go to `diagnostics` and
/// nothing is returned.
std::vector<CoefficientRow> read_coefficient_table(const std::string& path, Diagnostics& diagnostics);

}  // namespace overbend
