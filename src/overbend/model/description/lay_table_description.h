/// Lay table: one quantity varied, each row an independent equilibrium.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace overbend {

enum class LayTableVary {
  tension,   ///< Tension at the tensioner.
  lay_back,  ///< Distance from stern shoe to touchdown; the tension follows.
  depth,     ///< Water depth, at a constant tension.
};

/// Selection of the tension of the rows along a route.
enum class RouteTension {
  hold,     ///< Tension of the tensioner.
  minimum,  ///< Minimum tension that passes every governing check.
};

/// Point of the route at which a lay is calculated.
struct RouteDepth {
  double distance = 0.0;  ///< KP along the route [m].
  double depth = 0.0;     ///< Water depth at the stern shoe [m].
};

struct LayTableDescription {
  LayTableVary vary = LayTableVary::tension;
  std::optional<double> from, to;             ///< Range of the varied quantity [N] or [m].
  int steps = 20;                             ///< Number of steps; there is one more row.
  std::vector<RouteDepth> profile;            ///< Alternative: rows at points of a route, by increasing distance.
  RouteTension tension = RouteTension::hold;  ///< Tension of the rows of a profile.
};

}  // namespace overbend
