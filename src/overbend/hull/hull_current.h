/// Current, and drag of the wave-induced flow, on the hull: strips along its length, the coefficients of UFC 4-159-03
/// or a table of coefficients.
#pragma once

#include <array>

#include "hull/coefficient_flow.h"

namespace overbend {

inline constexpr int kHullStrips = 8;

/// Horizontal water velocity in H at the strips, from aft to forward [m/s].
struct StripWater {
  std::array<double, kHullStrips> along{}, across{};
};

/// Current and coefficients of a hull.
struct HullCurrent {
  HullCurrentModel form = HullCurrentModel::none;
  Eigen::Vector2d velocity = Eigen::Vector2d::Zero();  ///< At half the draught, in W [m/s].
  double water_density = 1025.0;                       ///< [kg/m3]
  double length = 0.0, beam = 0.0, draught = 0.0;      ///< Dimensions of the hull [m].
  Vec3 reference_V = Vec3::Zero();                     ///< Reference point of the forces [m].
  // For strips and UFC 4-159-03.
  double transverse = 0.0, longitudinal = 0.0;  ///< C_y on L T, C_x on B T [-].
  double wetted_surface = 0.0;                  ///< Wetted surface for skin friction [m2].
  bool in_water = true;                         ///< The water velocity includes that of waves.
  CoefficientTable table;
};

/// True if the drag is evaluated by strips.
inline bool by_strips(const HullCurrent& current) {
  return current.form == HullCurrentModel::strips || current.form == HullCurrentModel::ufc;
}

/// Force of the water on the hull in H, conjugate to surge to yaw, and its derivative by the rates in H.
struct CurrentForce {
  Vec6 force = Vec6::Zero();
  Mat6 by_v = Mat6::Zero();
};

/// Returns the drag. `psi`: heading of H [rad], `v`: rates in H (surge to yaw), `waves`: wave velocities at the strips.
///
/// Strips: cross-flow drag 1/2 rho T C_y |v_r| v_r per length at half the draught, with the water velocity relative to
/// the hull there; axial drag 1/2 rho (B T C_x + S C_F) |u_r| u_r with the ITTC 1957 friction line.
///
/// UFC 4-159-03 (2005), section 4-5: 1/2 rho T C_yc V v_r per length and 1/2 rho (B T C_x + S C_F) V u_r with the total
/// speed V of the flow past the strip; the same for flow straight on the bow or the beam.
CurrentForce current_force(const HullCurrent& current, double psi, const Vec6& v, const StripWater& waves);

/// Returns the middle of strip i (from aft), from midship along V's x axis [m].
double strip_place(const HullCurrent& current, int i);

/// Hull data for the drag estimate of UFC 4-159-03 (2005).
struct UfcHull {
  double length = 0.0, beam = 0.0, draught = 0.0;  ///< At the waterline [m].
  double midship = 0.0, volume = 0.0;              ///< Midship section area, displaced volume [m2, m3].
};

/// Longitudinal form drag coefficient, on beam times draught.
inline constexpr double kUfcFormDrag = 0.1;

/// Returns the transverse drag coefficient of a ship or barge in water of this depth [m]: C0 + (3.2 - C0)(T/d)^2 with
/// C0 = 0.22 sqrt(L^2 A_m / (B V)).
double ufc_transverse_coefficient(const UfcHull& hull, double depth);

/// Returns the wetted surface 1.7 T L + V/T [m2].
double ufc_wetted_surface(const UfcHull& hull);

}  // namespace overbend
