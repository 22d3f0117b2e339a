/// Strength and safety factors of DNV-ST-F101 (edition 2021), for the installation phase: no corrosion allowance, so
/// that t2 is the nominal wall and t1 the nominal wall minus the fabrication tolerance.
///
/// The values of tables 5.1 to 5.4 are from two public restatements, the factor on strain from one
/// (docs/theory/checks.md); they have not been compared with the standard itself.
#pragma once

#include "model/description/check_settings.h"

namespace overbend {

/// Resistance factor gamma_m for ULS, ALS and SLS [-] (table 5.1).
inline constexpr double kMaterialResistance = 1.15;

/// Safety class resistance factor gamma_SC,LB for local buckling, load controlled, collapse and propagation [-]
/// (table 5.2).
double safety_class_factor(SafetyClass safety);

/// Resistance factor gamma_SC,DC on strain for the displacement-controlled criterion [-]; gamma_eps in older editions.
double strain_safety_factor(SafetyClass safety);

/// Fabrication factor alpha_fab [-] (table 5.4).
double fabrication_factor(Manufacture manufacture);

/// Characteristic strength: specified minimum strength times the material strength factor alpha_U [Pa] (sec. 5.3.3; no
/// derating, installation is cold).
inline double characteristic_strength(double specified_minimum, double alpha_u) {
  return alpha_u * specified_minimum;
}

/// f_cb = min(f_y, f_u/1.15) [Pa], for the burst pressure.
double burst_strength(double fy, double fu);

}  // namespace overbend
