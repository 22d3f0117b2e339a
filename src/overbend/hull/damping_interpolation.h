/// Radiation damping between and below the frequencies of a file.
#pragma once

#include <span>
#include <vector>

#include "model/description/hydrodynamic_data.h"

namespace overbend {

/// Damping of every point of the data, symmetric and without negative eigenvalues: panel codes give some where there is
/// hardly any damping, and next to irregular frequencies. `largest_negative`: share of the modes' peaks taken off.
std::vector<Mat6> passive_damping(const HydrodynamicData& data, double& largest_negative);

/// Fills `damping` at the frequencies `omega` from 0 to the last of the data, ascending: a natural cubic spline through
/// zero and the data's frequencies with `given` at each, below the first a power law.
void interpolate_damping(const HydrodynamicData& data, const std::vector<Mat6>& given, std::span<const double> omega,
                         std::span<Mat6> damping);

/// Exponent of a power law through the first three values, between 1 and 8; 2 where they change sign or vanish.
double low_exponent(const double (&omega)[3], const double (&value)[3]);

}  // namespace overbend
