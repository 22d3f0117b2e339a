/// Sliding friction of a roller on a line in statics: fully mobilised, in a prescribed direction, mu N along the pipe
/// or across.
#pragma once

#include "mechanics/roller_contact.h"

namespace overbend {

/// Direction of the fully mobilised friction on the pipe, as factors of mu N: 1, 0 or -1.
struct MobilisedFriction {
  double along = 0.0;   ///< Along the pipe, towards the tensioner: 1 while it is paid out.
  double across = 0.0;  ///< Along a bottom roller, to port.
  bool any() const { return along != 0.0 || across != 0.0; }
};

/// Coefficients with their signs, times the normal force.
struct MobilisedFrictionForce {
  double along = 0.0, across = 0.0;  ///< mu, signed [-].
  double normal = 0.0;               ///< [N]
  double stiffness = 0.0;            ///< Derivative of the normal force with penetration [N/m].
};

/// Returns minus the derivative of the friction forces on the nodes of the element with its unknowns, exact: the normal
/// force changes, the directions rotate with the pipe and with the distance, and the point moves along the pipe. Not
/// symmetric.
ElementMatrix mobilised_friction_tangent(const PlacedRoller& roller, const ClosestPoint& closest,
                                         const RollerDistance& distance, const RollerDistanceDerivatives& derivatives,
                                         const ElementVector& q, double length, const MobilisedFrictionForce& force);

}  // namespace overbend
