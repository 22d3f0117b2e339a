/// Slopes of the monotone piecewise cubic through points.
#pragma once

#include <vector>

namespace overbend {

/// Returns slopes at increasing knots `x`, at least two, for the cubic Hermite through `y` that preserves monotonicity
/// (Fritsch and Carlson 1980): inside the weighted harmonic mean of the neighbouring secants, 0 at extremes (Fritsch
/// and Butland 1984); at the ends the three-point formula, limited (Moler 2004, as scipy's PchipInterpolator).
std::vector<double> monotone_slopes(const std::vector<double>& x, const std::vector<double>& y);

}  // namespace overbend
