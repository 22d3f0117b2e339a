/// Local buckling under combined loading, DNV-ST-F101 (edition 2021) sec. 5.4.6: displacement controlled (DCC).
///
/// Verified against one public restatement, the girth weld factor against none: docs/theory/checks.md. SI units,
/// strains as numbers (0.002 = 0.2 %).
#pragma once

#include "checks/dnv_pressure.h"

namespace overbend {

/// Girth weld factor alpha_gw [-]: 1 up to D/t2 = 20, then 1.2 - 0.01 D/t2.
double girth_weld_factor(double slenderness);

/// 1 + 5.75 dp/p_b [-], increase of the strain capacity by internal `overpressure` dp = p_min - p_e if positive and the
/// burst pressure p_b is known [Pa]; else 1.
double internal_pressure_factor(double overpressure, double burst);

/// Characteristic strain capacity eps_c = 0.78 (t/D - 0.01)(1 + 5.75 dp/p_b) alpha_h^-1.5 alpha_gw [-], see above.
double strain_capacity(const Wall& wall, double alpha_h, double overpressure, double burst);

/// Section data of the displacement-controlled criterion.
struct StrainCapacity {
  double strain_factor = 0.0;    ///< gamma_SC,DC/eps_c(t2, 0) [-].
  double collapse_factor = 0.0;  ///< gamma_m gamma_SC/p_c(t2) [1/Pa].
  double burst = 0.0;            ///< p_b(t2) [Pa]; 0 without a tensile strength: then internal pressure has no effect.
  bool holds = false;            ///< True if D/t2 < 45 and the capacity is positive.
};

/// Pressure part and strain part; the utilisation is their sum.
struct StrainTerms {
  double strain = 0.0;    ///< gamma eps_Sd/eps_c, proportional to the strain.
  double exponent = 1.0;  ///< 0.8 under external overpressure.
  double pressure = 0.0;

  double utilisation() const;
  /// Returns the factor on the strain that makes the utilisation 1 [-]; 0 if pressure alone exceeds it.
  double reserve() const;
};

/// Returns the terms for the design strain eps_Sd >= 0 under external and internal pressure [Pa].
StrainTerms strain_terms(const StrainCapacity& capacity, double strain, double external, double internal);

}  // namespace overbend
