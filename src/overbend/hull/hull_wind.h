/// Steady wind on the hull above the water: on areas [DNV and MODU-code form], or by a table of coefficients.
#pragma once

#include <vector>

#include "hull/coefficient_flow.h"

namespace overbend {

struct HullWind {
  /// Velocity of the air in W, horizontal [m/s].
  Eigen::Vector2d velocity = Eigen::Vector2d::Zero();
  double density = 1.226;  ///< [kg/m3]
  Vec3 reference_V = Vec3::Zero();
  std::vector<WindAreaDescription> areas;
  CoefficientTable table;  ///< In place of areas, where it has rows.
};

/// Force along H's axes and moment about the reference point, conjugate to surge to yaw; the hull heads psi [rad]. An
/// area that faces the bow takes 1/2 rho |V| V_x C_s C_h A, one that faces the side the same with V_y; a
/// table's forces act at the height of the reference point. [N, N m]
Vec6 wind_force(const HullWind& wind, double psi);

}  // namespace overbend
