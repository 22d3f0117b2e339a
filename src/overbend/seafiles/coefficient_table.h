/// Current or wind force coefficients by direction.
#pragma once

#include <string>
#include <vector>

#include "base/diagnostics.h"
#include "model/description/hull_description.h"

namespace overbend {

/// Reads a CSV file with the columns angle_deg,cx,cy,cz. Angles increase over the full circle without a gap above
/// 60 deg, or from 0 to 180 deg; the other side is then mirrored (cy and cz change sign). Comments begin with '#'. On
/// error, reports to `diagnostics` and returns an empty list.
std::vector<CoefficientRow> read_coefficient_table(const std::string& path, Diagnostics& diagnostics);

}  // namespace overbend
