/// Local buckling under combined loading, DNV-ST-F101 (edition 2021) sec. 5.4.6: load controlled (LCC).
///
/// The format has been in use since DNV-OS-F101 2007. Verified against one public restatement of it (S_p and M_p
/// against two), the reduction by a point load against none: docs/theory/checks.md. SI units.
#pragma once

#include "checks/dnv_pressure.h"

namespace overbend {

/// beta [-]: 0.5 below D/t2 = 15, falling linearly to 0 at 60.
double slenderness_factor(double slenderness);

/// Flow stress factor alpha_c = 1 - beta + beta f_u/f_y [-].
double flow_stress_factor(double slenderness, double fy, double fu);

/// S_p = f_y pi (D - t2) t2 [N].
double plastic_axial_force(const Wall& wall, double fy);

/// M_p = f_y (D - t2)^2 t2 [N m].
double plastic_moment(const Wall& wall, double fy);

/// alpha_pm = 1 - (D/t2)/130 R/R_y with R_y = 3.9 f_y t2^2 [-]: fraction of M_p that remains under a point load R [N]
/// from a roller (since 2012). Not below 0.05, where the capacity is practically exhausted.
double point_load_factor(const Wall& wall, double fy, double roller_force);

/// Section data of the load-controlled criterion, so that its evaluation is a few products.
struct LoadCapacity {
  double moment_factor = 0.0;    ///< gamma_m gamma_SC/(alpha_c M_p) [1/(N m)].
  double tension_factor = 0.0;   ///< gamma_m gamma_SC/(alpha_c S_p) [1/N].
  double collapse_factor = 0.0;  ///< gamma_m gamma_SC/p_c(t2) [1/Pa].
  double burst = 0.0;            ///< p_b(t2) [Pa].
  double alpha_c = 0.0, beta = 0.0;
  double axial_limit = 0.0;     ///< 0.4 S_p: limit of validity of the formula [N].
  bool slender_enough = false;  ///< 15 <= D/t2 <= 45.
  bool known = false;           ///< False without a tensile strength: no capacity.
};

/// Returns the capacity with gamma_m gamma_SC as `factor`; strengths and p_c(t2) in Pa.
LoadCapacity load_capacity(const Wall& wall, double fy, double fu, double collapse, double factor);

/// Parts of the utilisation: (moment + axial^2)^2 + pressure.
struct LoadTerms {
  double moment = 0.0;    ///< Part of the design moment, proportional to it.
  double axial = 0.0;     ///< Part of the design effective force, proportional to it.
  double pressure = 0.0;  ///< Squared; not scaled with the load effects.

  double utilisation() const {
    const double bracket = moment + axial * axial;
    return bracket * bracket + pressure;
  }
};

/// Returns the terms for the design moment M_Sd [N m, >= 0] and effective force S_Sd [N], under external and internal
/// pressure [Pa]. `plastic_share` is alpha_pm. External overpressure: equation for p_e >= p_i; internal overpressure:
/// the other one.
LoadTerms load_terms(const LoadCapacity& capacity, double moment, double force, double external, double internal,
                     double plastic_share = 1.0);

/// alpha_p [-] for `ratio` = (p_i - p_e)/p_b: 1 - beta below 2/3, then rising to 1 at the burst pressure.
double burst_share_factor(double beta, double ratio);

/// Returns the factor lambda on moment and force that makes the utilisation 1 [-]; 0 if pressure alone exceeds it; at
/// most kMaxReserve.
double load_reserve(const LoadTerms& terms);

inline constexpr double kMaxReserve = 999.0;

/// True if the formula is valid for this section and design force.
inline bool load_formula_holds(const LoadCapacity& capacity, double force) {
  return capacity.slender_enough && force < capacity.axial_limit && force > -capacity.axial_limit;
}

}  // namespace overbend
