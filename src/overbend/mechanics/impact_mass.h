/// Effective mass of a long pipe in a hard, short contact.
#pragma once

#include <cmath>

namespace overbend {

/// A harmonic force of frequency w at a point of an endless beam sees the impedance 2 m' c_b (1 + i), c_b = (EI
/// w^2/m')^(1/4) (Cremer, Heckl & Petersson 2005, section 5.4), equivalent to a mass 2 m' c_b/w: the part that bending
/// waves reach during the contact. With w = sqrt(k/m) of this mass on the contact's spring it follows in closed form, m
/// = 2^(4/3) m' (EI/k)^(1/3). `mass_per_length` [kg/m], `EI` [N m2], `stiffness` of the contact [N/m]. Returns [kg].
inline double impact_mass(double mass_per_length, double EI, double stiffness) {
  return std::cbrt(16.0 * EI / stiffness) * mass_per_length;
}

}  // namespace overbend
