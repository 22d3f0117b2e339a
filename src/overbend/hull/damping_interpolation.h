/// Radiation damping between and below the frequencies of a file.
#pragma once

#include <span>

#include "model/hydrodynamic_data.h"

namespace overbend {

/// Fills `damping` at the frequencies `omega` from 0 to the last of the data, ascending: a natural cubic spline through
/// zero and the data, below their first frequency a power law. Symmetric.
void interpolate_damping(const HydrodynamicData& data, std::span<const double> omega, std::span<Mat6> damping);

/// Exponent of a power law through the first three values, between 1 and 8; 2 where they change sign or vanish.
double low_exponent(const double (&omega)[3], const double (&value)[3]);

}  // namespace overbend
