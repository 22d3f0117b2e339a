/// A table of lays: one quantity varied, each row an equilibrium of its own.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace overbend {

enum class LayTableVary {
  tension,   ///< At the tensioner.
  lay_back,  ///< Stern shoe to touchdown; the tension follows.
  depth,     ///< Of the water, at a held tension.
};

/// How the tension of the rows along a route is chosen.
enum class RouteTension {
  hold,   ///< That of the tensioner.
  least,  ///< The least with which every governing check is passed.
};

/// A point of the route at which a lay is calculated.
struct RouteDepth {
  double distance = 0.0;  ///< Along the route, KP [m].
  double depth = 0.0;     ///< Of the water at the stern shoe [m].
};

struct LayTableDescription {
  LayTableVary vary = LayTableVary::tension;
  std::optional<double> from, to;             ///< Of what varies [N] or [m].
  int steps = 20;                             ///< Rows are one more.
  std::vector<RouteDepth> profile;            ///< Instead: rows at the points of a route, by increasing distance.
  RouteTension tension = RouteTension::hold;  ///< Of the rows of a profile.
};

}  // namespace overbend
