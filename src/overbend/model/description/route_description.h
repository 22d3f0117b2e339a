/// Lay route in plan as given in the model file. SI.
#pragma once

#include <vector>

namespace overbend {

/// Point of the route: x astern of the stern shoe along the axis of the barge in its nominal pose, y to port [m].
struct RoutePoint {
  double x = 0.0, y = 0.0;
};

/// Leg of the route, from the barge astern: straight with `length`, or an arc.
struct RouteLeg {
  double length = 0.0;  ///< Length of a straight leg [m].
  double radius = 0.0;  ///< Radius of an arc; 0: straight [m].
  double angle = 0.0;   ///< Change of direction along the arc, positive to port going astern [rad].
};

/// Either points or legs; without both the route is straight astern.
struct RouteDescription {
  std::vector<RoutePoint> points;  ///< Joined by straight lines, rounded at the corners with `corner_radius`.
  double corner_radius = 0.0;      ///< [m]; 0: minimum radius that friction holds, with a margin.
  std::vector<RouteLeg> legs;
  bool given() const { return !points.empty() || !legs.empty(); }
};

}  // namespace overbend
