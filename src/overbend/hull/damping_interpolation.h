/// Interpolation of radiation damping between and below the frequencies of a file.
#pragma once

#include <span>
#include <vector>

#include "model/description/hydrodynamic_data.h"

namespace overbend {

/// Returns the damping of every data point, symmetric and without negative eigenvalues: panel codes give some where
/// there is hardly any damping, and near irregular frequencies. `max_negative_damping`: maximum correction as a share
/// of the modes' peaks.
std::vector<Mat6> passive_damping(const HydrodynamicData& data, double& max_negative_damping);

/// Sets `damping` at the frequencies `omega` from 0 to the last of the data, ascending: a natural cubic spline through
/// zero and the data's frequencies with `file_damping` at each, below the first a power law.
void interpolate_damping(const HydrodynamicData& data, const std::vector<Mat6>& file_damping,
                         std::span<const double> omega, std::span<Mat6> damping);

/// Returns the exponent of a power law through the first three values, between 1 and 8; 2 if they change sign or
/// vanish.
double low_exponent(const double (&omega)[3], const double (&value)[3]);

}  // namespace overbend
