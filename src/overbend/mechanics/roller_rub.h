/// Sliding friction of a roller on a line at rest: full, in a direction known beforehand, mu N along the pipe or
/// across.
#pragma once

#include "mechanics/roller_contact.h"

namespace overbend {

/// Which way full friction pushes the pipe, as factors of mu N: 1, 0 or -1.
struct RollerRub {
  double along = 0.0;   ///< Along the pipe, towards the tensioner: 1 while it is paid out.
  double across = 0.0;  ///< Along a bottom roller, to port.
  bool any() const { return along != 0.0 || across != 0.0; }
};

/// Coefficients with their signs, times the normal force.
struct RubForce {
  double along = 0.0, across = 0.0;  ///< mu, signed [-].
  double normal = 0.0;               ///< [N]
  double stiffness = 0.0;            ///< By which the normal force follows penetration [N/m].
};

/// Minus the change of the friction's forces on the nodes of the element with its unknowns, exact: the normal force
/// changes, the directions turn with the pipe and with the distance, and the point moves along the pipe. Not symmetric.
ElementMatrix rub_tangent(const PlacedRoller& roller, const ClosestPoint& at, const RollerDistance& distance,
                          const RollerDistanceDerivatives& derivatives, const ElementVector& q, double length,
                          const RubForce& force);

}  // namespace overbend
