/// Current, and drag of the water under waves, on the hull: strips along its length or a table of coefficients.
#pragma once

#include <array>
#include <vector>

#include "model/hull_description.h"

namespace overbend {

inline constexpr int kHullStrips = 8;

/// Horizontal velocity of the water in H at the strips, from aft to forward [m/s].
struct StripWater {
  std::array<double, kHullStrips> along{}, across{};
};

struct HullCurrent {
  HullCurrentForm form = HullCurrentForm::none;
  Eigen::Vector2d velocity = Eigen::Vector2d::Zero();  ///< At half the draught, in W [m/s].
  double water_density = 1025.0;                       ///< [kg/m3]
  double length = 0.0, beam = 0.0, draught = 0.0;      ///< Of the hull [m].
  Vec3 reference_V = Vec3::Zero();                     ///< Reference point, of which the forces are [m].
  // Strips.
  double transverse = 0.0, longitudinal = 0.0;  ///< C_y on L T, C_x on B T [-].
  double wetted_surface = 0.0;                  ///< Of the skin friction [m2].
  bool in_water = true;                         ///< The water's velocity includes that under waves.
  // Table.
  double frontal_area = 0.0, lateral_area = 0.0, table_length = 0.0;  ///< [m2, m2, m]
  std::vector<CoefficientRow> table;  ///< By where the flow goes to, anticlockwise from the bow, [0, 2 pi), F along V.
};

/// Force of the water on the hull in H, conjugate to surge to yaw, and its derivative by the rates of H.
struct CurrentForce {
  Vec6 force = Vec6::Zero();
  Mat6 by_v = Mat6::Zero();
};

/// `psi` heading of H [rad], `v` rates in H (surge to yaw), `waves` the water's motion under waves at the strips.
///
/// Strips: cross-flow drag 1/2 rho T C_y |v_r| v_r per length, at half the draught, with the water's velocity less that
/// of the hull there; axial drag 1/2 rho (B T C_x + S C_F) |u_r| u_r with the friction line of ITTC 1957.
CurrentForce current_force(const HullCurrent& current, double psi, const Vec6& v, const StripWater& waves);

/// Where strip i (from aft) has its middle, from midship along V's x axis [m].
double strip_place(const HullCurrent& current, int i);

/// Rows by where the flow goes to, anticlockwise from the bow, sorted, from a table whose angles are counted otherwise:
/// `from_bow` where the flow comes from, clockwise from the bow; `from_stern_ocimf` where it comes from, anticlockwise
/// from the stern. Forces are along x forward and y to port, moments positive bow to port, as OCIMF's are, in all
/// three.
std::vector<CoefficientRow> coefficients_from_bow(std::vector<CoefficientRow> rows, CoefficientAxes axes);

/// Transverse drag coefficient of a ship or barge in shallow water by UFC 4-159-03 (2005): C0 + (3.2 - C0)(T/d)^2 with
/// C0 = 0.22 sqrt(L^2 A_m / (B V)). `midship` area A_m [m2], `volume` V displaced [m3].
double ufc_transverse_coefficient(double length, double beam, double draught, double midship, double volume,
                                  double depth);

}  // namespace overbend
