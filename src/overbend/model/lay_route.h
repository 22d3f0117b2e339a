/// Lay route in plan: position, direction and curvature as functions of the distance s along it behind the tensioner. A
/// sequence of straight lines and arcs without kinks.
#pragma once

#include <memory>
#include <vector>

#include "base/vec.h"
#include "model/model.h"
#include "model/site/route_piece.h"

namespace overbend {

class LayRoute {
 public:
  /// Straight from `start_W`, where s = 0, towards the horizontal unit vector `astern_W`.
  LayRoute(const Vec3& start_W, const Vec3& astern_W);
  /// Straight for `lead` [m], then leg by leg, then straight on. An arc must turn by less than 180 degrees.
  LayRoute(const Vec3& start_W, const Vec3& astern_W, double lead, const std::vector<RouteLeg>& legs);

  /// Position at the height of the start [m].
  Vec3 place(double s) const;
  /// Horizontal unit vector away from the barge.
  Vec3 direction(double s) const;
  /// Horizontal unit vector across the route, to the barge's port.
  Vec3 port(double s) const;
  /// Curvature of the route in plan, positive where it turns to port with s [1/m].
  double curvature(double s) const;
  /// Returns s of the point of the route that is nearest in plan [m].
  double distance(const Vec3& p_W) const;
  /// Returns the distance in plan from the route, to port [m].
  double offset(const Vec3& p_W) const;

  bool straight() const { return !pieces_; }
  /// Returns the parallel route at a constant distance `to_port` [m], with the same s.
  LayRoute parallel_route(double to_port) const;
  /// Distance from the original route, to port [m].
  double shift() const { return shift_; }
  /// Max. curvature of the route beyond s, 0 if straight [1/m].
  double max_curvature_beyond(double s) const;
  /// Pieces of a curved route, for kernels; null if straight. The caller keeps the pointer as long as it uses the data.
  const std::shared_ptr<const std::vector<RoutePiece>>& pieces() const { return pieces_; }
  /// port . point of a straight route, for kernels, which compute `offset` themselves [m].
  double port_offset() const { return port_offset_; }

 private:
  Vec3 start_W_, astern_W_, port_W_;
  double port_offset_ = 0.0, shift_ = 0.0;
  std::shared_ptr<const std::vector<RoutePiece>> pieces_;  ///< Null for a straight route.
};

/// Returns the route of the barge as described: from the pipe's axis at the tensioner, straight astern to the stern
/// shoe and from there along the legs or points. The route stays in place if the barge drifts on its moorings.
LayRoute lay_route(const Model& model);

/// Returns the legs of a route: those given, or straight lines between its points with an arc at each corner.
std::vector<RouteLeg> route_legs(const RouteDescription& route, double corner_radius);

/// Returns the default radius for the corners of a route through points [m]: kRouteReserve times the minimum that
/// friction holds under the bottom tension of a cable without bending stiffness, T - integral of w over the depth; less
/// if the points are too close for that.
double default_corner_radius(const Model& model);

/// Ratio of a route radius to the minimum that friction holds, from which a curve counts as held with a margin [-].
inline constexpr double kRouteReserve = 1.5;

}  // namespace overbend
