#include "checks/dnv_strain.h"

#include <algorithm>
#include <cmath>

#include "checks/dnv_combined.h"

namespace overbend {

double girth_weld_factor(double slenderness) {
  return slenderness <= 20.0 ? 1.0 : 1.2 - 0.01 * slenderness;
}

double internal_pressure_factor(double overpressure, double burst) {
  return overpressure > 0.0 && burst > 0.0 ? 1.0 + 5.75 * overpressure / burst : 1.0;
}

double strain_capacity(const Wall& wall, double alpha_h, double overpressure, double burst) {
  return 0.78 * (1.0 / wall.slenderness() - 0.01) * internal_pressure_factor(overpressure, burst) *
         std::pow(alpha_h, -1.5) * girth_weld_factor(wall.slenderness());
}

double StrainTerms::utilisation() const {
  return (exponent == 1.0 ? strain : std::pow(strain, exponent)) + pressure;
}

double StrainTerms::reserve() const {
  if (pressure >= 1.0) return 0.0;
  return strain > 0.0 ? std::min(std::pow(1.0 - pressure, 1.0 / exponent) / strain, kMaxReserve) : kMaxReserve;
}

StrainTerms strain_terms(const StrainCapacity& capacity, double strain, double external, double internal) {
  StrainTerms terms;
  terms.strain = capacity.strain_factor * strain;
  if (external >= internal) {
    terms.exponent = 0.8;
    terms.pressure = capacity.collapse_factor * (external - internal);
  } else {
    terms.strain /= internal_pressure_factor(internal - external, capacity.burst);
  }
  return terms;
}

}  // namespace overbend
