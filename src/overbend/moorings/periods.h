/// Natural periods of a hull on its lines.
#pragma once

#include <string>
#include <vector>

#include "model/description/hull_description.h"

namespace overbend {

struct NaturalPeriod {
  std::string mode;     ///< Motion that contains most of the kinetic energy: surge, sway, ...
  double period = 0.0;  ///< Undamped [s].
};

/// Returns undamped modes by decreasing period, with the added mass at each mode's own frequency (interpolated linearly
/// between the frequencies of the file; constant below the first). `stiffness`: lines and hydrostatics about the centre
/// of gravity [N/m, N, N m]. Modes without stiffness are omitted.
std::vector<NaturalPeriod> natural_periods(const CoupledHullDescription& hull, const Mat6& stiffness);

}  // namespace overbend
