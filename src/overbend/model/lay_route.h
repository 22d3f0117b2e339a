/// The line on which the pipe is laid, in plan: place, direction and curvature as functions of the distance s along it
/// behind the tensioner. Straight lines and arcs, one after the other without a kink.
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

  /// At the height of the start [m].
  Vec3 place(double s) const;
  /// Horizontal unit vector away from the barge.
  Vec3 direction(double s) const;
  /// Horizontal unit vector across the route, to the barge's port.
  Vec3 port(double s) const;
  /// Of the route in plan, positive where it turns to port with s [1/m].
  double curvature(double s) const;
  /// s of the point of the route that is nearest in plan [m].
  double distance(const Vec3& p_W) const;
  /// Distance in plan from there, to port [m].
  double offset(const Vec3& p_W) const;

  bool straight() const { return !pieces_; }
  /// The line beside this one, `to_port` metres away everywhere, with the same s.
  LayRoute beside(double to_port) const;
  /// How far it lies from the route it was made from, to port [m].
  double shift() const { return shift_; }
  /// Largest curvature of the route behind s, 0 where it is straight [1/m].
  double sharpest_behind(double s) const;
  /// What kernels take: the pieces of a route that is not straight, which whoever points to them must keep.
  const std::shared_ptr<const std::vector<RoutePiece>>& pieces() const { return pieces_; }
  /// port . point of a straight route, for kernels, which compute `offset` themselves [m].
  double port_offset() const { return port_offset_; }

 private:
  Vec3 start_W_, astern_W_, port_W_;
  double port_offset_ = 0.0, shift_ = 0.0;
  std::shared_ptr<const std::vector<RoutePiece>> pieces_;  ///< Of a route that is not straight.
};

/// The route of the barge as described: from the pipe's axis at the tensioner, straight astern to the stern shoe and
/// from there as the legs or points say. A barge that its moorings let drift does not take it along.
LayRoute lay_route(const Model& model);

/// Legs of a route: those described, or the straight lines between its points with an arc at each corner.
std::vector<RouteLeg> route_legs(const RouteDescription& route, double corner_radius);

/// Radius with which corners of a route through points are rounded where the description gives none: kRouteReserve
/// times the least that friction holds under the bottom tension of a cable without bending stiffness, T - integral of w
/// over the depth; less where the points lie too close for that [m].
double default_corner_radius(const Model& model);

/// Radius of the route over the least that friction holds, from which a curve counts as held with a margin.
inline constexpr double kRouteReserve = 1.5;

}  // namespace overbend
