/// Pressure resistance of a pipe, DNV-ST-F101 (edition 2021). Diameters and walls in m, stresses and pressures in Pa.
///
/// Verified against public restatements, named in docs/theory/checks.md, not against the printed standard: collapse,
/// propagation and burst pressure against two or more, the cross-over of a buckle arrestor against one. Equation
/// numbers are those of the edition.
#pragma once

namespace overbend {

/// Pipe wall used in the formulas.
struct Wall {
  double diameter = 0.0;        ///< Nominal outside diameter D [m].
  double thickness = 0.0;       ///< t1 or t2 [m].
  double youngs_modulus = 0.0;  ///< [Pa]
  double poissons_ratio = 0.0;  ///< [-]

  double slenderness() const { return diameter / thickness; }
};

/// p_el = 2 E (t/D)^3 / (1 - nu^2) [Pa] (5.4.4, eq. 5.14).
double elastic_collapse_pressure(const Wall& wall);

/// p_p = f_y alpha_fab 2 t/D [Pa] (5.4.4, eq. 5.15).
double plastic_collapse_pressure(const Wall& wall, double fy, double alpha_fab);

/// p_c from (p_c - p_el)(p_c^2 - p_p^2) = p_c p_el p_p O_0 D/t [Pa] (5.4.4; the check with it is eq. 5.12), by the
/// closed solution of the cubic (sec. 13). `ovality` O_0 = (D_max - D_min)/D > 0; the standard requires at least 0.005.
double collapse_pressure(const Wall& wall, double fy, double alpha_fab, double ovality);

/// p_pr = 35 f_y alpha_fab (t2/D)^2.5 [Pa] (5.4.5, eq. 5.21), for 15 < D/t2 < 45.
double propagation_pressure(const Wall& wall, double fy, double alpha_fab);

/// Pressure at which a running buckle crosses an arrestor [Pa]: p_pr + (p_BA - p_pr)(1 - exp(-20 t2 L/D^2)) (5.4.5, eq.
/// 5.22 and 5.23). `resistance` is the propagation pressure of the arrestor, `length` its length [m].
double crossover_pressure(const Wall& wall, double propagation, double resistance, double length);

/// p_b = 2 t/(D - t) f_cb 2/sqrt(3) [Pa] (5.4.2).
double burst_pressure(const Wall& wall, double fcb);

}  // namespace overbend
