/// Steady wind on the hull above water: on areas [DNV and MODU-code form], or by a table of coefficients.
#pragma once

#include <vector>

#include "hull/coefficient_flow.h"

namespace overbend {

/// Wind and wind areas of a hull.
struct HullWind {
  /// Velocity of the air in W, horizontal [m/s].
  Eigen::Vector2d velocity = Eigen::Vector2d::Zero();
  double density = 1.226;  ///< [kg/m3]
  Vec3 reference_V = Vec3::Zero();
  std::vector<WindAreaDescription> areas;
  CoefficientTable table;  ///< Used instead of the areas if it has rows.
};

/// Returns the force along H's axes and the moment about the reference point, conjugate to surge to yaw, for heading
/// psi [rad]. An area facing the bow takes 1/2 rho |V| V_x C_s C_h A, one facing the side the same with V_y; the forces
/// of a table act at the height of the reference point. [N, N m]
Vec6 wind_force(const HullWind& wind, double psi);

}  // namespace overbend
