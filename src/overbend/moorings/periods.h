/// Natural periods of a hull on its lines.
#pragma once

#include <string>
#include <vector>

#include "model/description/hull_description.h"

namespace overbend {

struct NaturalPeriod {
  std::string mode;     ///< The motion that holds most of its kinetic energy: surge, sway, ...
  double period = 0.0;  ///< Undamped [s].
};

/// Undamped modes by falling period, with the added mass at each mode's own frequency (linear between the file's; the
/// first below them). `stiffness` of lines and water about the centre of gravity [N/m, N, N m]; modes without stiffness
/// are left out.
std::vector<NaturalPeriod> natural_periods(const CoupledHullDescription& hull, const Mat6& stiffness);

}  // namespace overbend
