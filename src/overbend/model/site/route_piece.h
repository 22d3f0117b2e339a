/// Piece of the lay route as plain numbers, used directly by kernels.
#pragma once

namespace overbend {

/// Straight line or arc of the route, up to the beginning of the next piece; the last is unbounded.
struct RoutePiece {
  double s = 0.0;             ///< s at its beginning [m].
  double x = 0.0, y = 0.0;    ///< Position of its beginning, W [m].
  double tx = 1.0, ty = 0.0;  ///< Direction at its beginning, away from the barge.
  double curvature = 0.0;     ///< Positive where it turns to port [1/m].
};

}  // namespace overbend
