/// API RP 1111, 3rd (1999) and 4th edition (2009): collapse, bending with external pressure, propagation, tension and
/// combined load of a pipeline under installation. Nominal dimensions. Verified against public restatements: collapse,
/// bending, propagation, burst and tension against two, the buckling strain against one, g against none
/// (docs/theory/checks.md). SI.
#pragma once

namespace overbend {

struct ApiPipe {
  double diameter = 0.0, wall = 0.0;  ///< Nominal [m].
  double yield_stress = 0.0;          ///< S = SMYS [Pa].
  double youngs_modulus = 0.0;        ///< [Pa]
  double poissons_ratio = 0.0;        ///< [-]
};

/// P_y = 2 S t/D and P_e = 2 E (t/D)^3/(1 - nu^2) [Pa].
double api_yield_pressure(const ApiPipe& pipe);
double api_elastic_pressure(const ApiPipe& pipe);

/// P_c = P_y P_e/sqrt(P_y^2 + P_e^2) [Pa] (4.3.2.1).
double api_collapse_pressure(const ApiPipe& pipe);

/// eps_b = t/(2 D) [-]: buckling strain under pure bending (4.3.2.2).
double api_buckling_strain(const ApiPipe& pipe);

/// g = 1/(1 + 20 delta) [-]; `delta` = (D_max - D_min)/(D_max + D_min), half of DNV's O_0 for the same pipe.
double api_ovality_factor(double delta);

/// (eps/eps_b + (P_o - P_i)/(f_c P_c))/g [-], must not exceed 1 (4.3.2.2, valid for D/t <= 50). `strain` is f_1 times
/// the installation strain; without external overpressure its term is 0.
double api_bending_utilisation(const ApiPipe& pipe, double strain, double overpressure, double collapse_factor,
                               double delta);

/// P_p = 24 S (t/D)^2.4 [Pa] (4.3.2.3). Buckle arrestors are required if P_o - P_i >= 0.80 P_p.
double api_propagation_pressure(const ApiPipe& pipe);

/// T_y = S A [N]; the effective tension is limited to 0.60 T_y (4.3.1.1).
double api_yield_tension(const ApiPipe& pipe);

/// P_b = 0.45 (S + U) ln(D/D_i) [Pa], with U the tensile strength.
double api_burst_pressure(const ApiPipe& pipe, double tensile_strength);

/// sqrt(((P_i - P_o)/P_b)^2 + (T_eff/T_y)^2) [-] (4.3.1.2), limited to 0.90 for functional and 0.96 for extreme loads;
/// one public text has 0.96 for installation as well.
double api_combined_load(const ApiPipe& pipe, double tensile_strength, double overpressure, double tension);

inline constexpr double kApiPropagationFactor = 0.80;
inline constexpr double kApiTensionFactor = 0.60;
inline constexpr double kApiFunctionalLimit = 0.90;
inline constexpr double kApiExtremeLimit = 0.96;

}  // namespace overbend
