/// The lay route in plan as the model file describes it. SI.
#pragma once

#include <vector>

namespace overbend {

/// A point of the route: x astern of the stern shoe along the barge as drawn, y to port [m].
struct RoutePoint {
  double x = 0.0, y = 0.0;
};

/// A stretch of the route, from the barge astern: straight for `length`, or an arc.
struct RouteLeg {
  double length = 0.0;  ///< Of a straight leg [m].
  double radius = 0.0;  ///< Of an arc; 0: straight [m].
  double angle = 0.0;   ///< The arc turns by, positive to port going astern [rad].
};

/// Points or legs, not both; neither: straight astern.
struct RouteDescription {
  std::vector<RoutePoint> points;  ///< Joined by straight lines, rounded at the corners with `corner_radius`.
  double corner_radius = 0.0;      ///< [m]; 0: the least that friction holds.
  std::vector<RouteLeg> legs;
  bool given() const { return !points.empty() || !legs.empty(); }
};

}  // namespace overbend
