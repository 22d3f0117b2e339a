/// A piece of the lay route, plain numbers: kernels take them as they are.
#pragma once

namespace overbend {

/// A straight line or an arc of the route, up to where the next one begins; the last goes on for ever.
struct RoutePiece {
  double s = 0.0;             ///< Where it begins [m].
  double x = 0.0, y = 0.0;    ///< The same, W [m].
  double tx = 1.0, ty = 0.0;  ///< Direction there, away from the barge.
  double curvature = 0.0;     ///< Positive where it turns to port [1/m].
};

}  // namespace overbend
