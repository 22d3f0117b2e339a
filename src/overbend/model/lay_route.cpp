#include "model/lay_route.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "base/ranges.h"

namespace overbend {
namespace {

/// Returns the unit vector to port of a horizontal direction that points away from the barge.
Vec3 port_direction(double tx, double ty) {
  return {ty, -tx, 0.0};
}

/// Returns the piece as seen from a point `along` metres after its beginning.
RoutePiece moved(const RoutePiece& piece, double along) {
  const Vec3 port = port_direction(piece.tx, piece.ty);
  const double turn = piece.curvature * along;
  // sin(turn)/curvature and (1 - cos(turn))/curvature, accurate at small angles too
  const double half = std::sin(0.5 * turn);
  const double ahead = turn == 0.0 ? along : std::sin(turn) / piece.curvature;
  const double aside = turn == 0.0 ? 0.0 : 2.0 * half * half / piece.curvature;
  RoutePiece moved_piece = piece;
  moved_piece.s += along;
  moved_piece.x += ahead * piece.tx + aside * port.x();
  moved_piece.y += ahead * piece.ty + aside * port.y();
  moved_piece.tx = std::cos(turn) * piece.tx + std::sin(turn) * port.x();
  moved_piece.ty = std::cos(turn) * piece.ty + std::sin(turn) * port.y();
  return moved_piece;
}

const RoutePiece& piece_at(const std::vector<RoutePiece>& pieces, double s) {
  std::size_t i = 0;
  while (i + 1 < pieces.size() && s >= pieces[i + 1].s) ++i;
  return pieces[i];
}

const RoutePiece& find_nearest_piece(const std::vector<RoutePiece>& pieces, const Vec3& p) {
  std::size_t i = 0;
  while (i + 1 < pieces.size() &&
         (p.x() - pieces[i + 1].x) * pieces[i + 1].tx + (p.y() - pieces[i + 1].y) * pieces[i + 1].ty >= 0.0) {
    ++i;
  }
  return pieces[i];
}

}  // namespace

LayRoute::LayRoute(const Vec3& start_W, const Vec3& astern_W)
    : start_W_(start_W),
      astern_W_(astern_W),
      port_W_(astern_W.cross(Vec3::UnitZ())),
      port_offset_(port_W_.dot(start_W)) {}

LayRoute::LayRoute(const Vec3& start_W, const Vec3& astern_W, double lead, const std::vector<RouteLeg>& legs)
    : LayRoute(start_W, astern_W) {
  std::vector<RoutePiece> pieces{{0.0, start_W.x(), start_W.y(), astern_W.x(), astern_W.y(), 0.0}};
  double length = lead;
  for (const RouteLeg& leg : legs) {
    pieces.push_back(moved(pieces.back(), length));
    pieces.back().curvature = leg.radius > 0.0 ? std::copysign(1.0 / leg.radius, leg.angle) : 0.0;
    length = leg.radius > 0.0 ? leg.radius * std::abs(leg.angle) : leg.length;
  }
  pieces.push_back(moved(pieces.back(), length));
  pieces.back().curvature = 0.0;
  const bool bends = ranges::any_of(pieces, [](const RoutePiece& piece) { return piece.curvature != 0.0; });
  if (bends) pieces_ = std::make_shared<const std::vector<RoutePiece>>(std::move(pieces));
}

Vec3 LayRoute::place(double s) const {
  if (!pieces_) return start_W_ + s * astern_W_;
  const RoutePiece& piece = piece_at(*pieces_, s);
  const RoutePiece local_piece = moved(piece, s - piece.s);
  return Vec3(local_piece.x, local_piece.y, start_W_.z()) + shift_ * port_direction(local_piece.tx, local_piece.ty);
}

Vec3 LayRoute::direction(double s) const {
  if (!pieces_) return astern_W_;
  const RoutePiece& piece = piece_at(*pieces_, s);
  const RoutePiece local_piece = moved(piece, s - piece.s);
  return {local_piece.tx, local_piece.ty, 0.0};
}

Vec3 LayRoute::port(double s) const {
  if (!pieces_) return port_W_;
  return direction(s).cross(Vec3::UnitZ());
}

double LayRoute::curvature(double s) const {
  return pieces_ ? piece_at(*pieces_, s).curvature : 0.0;
}

double LayRoute::distance(const Vec3& p_W) const {
  if (!pieces_) return (p_W - start_W_).dot(astern_W_);
  const RoutePiece& piece = find_nearest_piece(*pieces_, p_W);
  const Vec3 t(piece.tx, piece.ty, 0.0), port = port_direction(piece.tx, piece.ty);
  const Vec3 from(p_W.x() - piece.x, p_W.y() - piece.y, 0.0);
  const double ahead = from.dot(t);
  if (piece.curvature == 0.0) return piece.s + ahead;
  // outwards from the centre of the arc
  const double radius = 1.0 / std::abs(piece.curvature);
  const double side = std::copysign(1.0, piece.curvature);
  return piece.s + radius * std::atan2(ahead, radius - side * from.dot(port));
}

double LayRoute::offset(const Vec3& p_W) const {
  if (!pieces_) return port_W_.dot(p_W) - port_offset_;
  const RoutePiece& piece = find_nearest_piece(*pieces_, p_W);
  const Vec3 port = port_direction(piece.tx, piece.ty);
  const Vec3 from(p_W.x() - piece.x, p_W.y() - piece.y, 0.0);
  if (piece.curvature == 0.0) return from.dot(port) - shift_;
  const double side = std::copysign(1.0, piece.curvature), radius = 1.0 / std::abs(piece.curvature);
  return side * (radius - (from - port / piece.curvature).norm()) - shift_;
}

LayRoute LayRoute::parallel_route(double to_port) const {
  LayRoute route = *this;
  route.shift_ += to_port;
  if (!pieces_) {
    route.start_W_ += to_port * port_W_;
    route.port_offset_ += to_port;
  }
  return route;
}

double LayRoute::max_curvature_beyond(double s) const {
  double sharpest = 0.0;
  for (std::size_t i = 0; pieces_ && i < pieces_->size(); ++i) {
    const bool behind = i + 1 == pieces_->size() || (*pieces_)[i + 1].s > s;
    if (behind) sharpest = std::max(sharpest, std::abs((*pieces_)[i].curvature));
  }
  return sharpest;
}

std::vector<RouteLeg> route_legs(const RouteDescription& route, double corner_radius) {
  if (!route.legs.empty() || route.points.empty()) return route.legs;
  std::vector<RouteLeg> legs;
  RoutePoint from{0.0, 0.0};
  double taken = 0.0;  // length of the line to the next point used by the previous corner [m]
  const std::size_t count = route.points.size();
  for (std::size_t i = 0; i < count; ++i) {
    const RoutePoint& point = route.points[i];
    const double length = std::hypot(point.x - from.x, point.y - from.y);
    if (i + 1 == count) {
      legs.push_back({length - taken, 0.0, 0.0});
      break;
    }
    const double direction = std::atan2(point.y - from.y, point.x - from.x);
    const double next = std::atan2(route.points[i + 1].y - point.y, route.points[i + 1].x - point.x);
    const double turn = std::remainder(next - direction, 2.0 * std::numbers::pi);
    const double cut = corner_radius * std::tan(0.5 * std::abs(turn));
    legs.push_back({length - taken - cut, 0.0, 0.0});
    if (turn != 0.0) legs.push_back({0.0, corner_radius, turn});
    taken = cut;
    from = point;
  }
  return legs;
}

namespace {

/// Returns the maximum radius whose arcs fit between the points, each using at most half of a line.
double compute_max_corner_radius(const std::vector<RoutePoint>& points) {
  double max_radius = std::numeric_limits<double>::infinity();
  RoutePoint from{0.0, 0.0};
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    const RoutePoint &point = points[i], &to = points[i + 1];
    const double before = std::hypot(point.x - from.x, point.y - from.y),
                 after = std::hypot(to.x - point.x, to.y - point.y);
    const double turn =
        std::remainder(std::atan2(to.y - point.y, to.x - point.x) - std::atan2(point.y - from.y, point.x - from.x),
                       2.0 * std::numbers::pi);
    if (turn != 0.0) {
      max_radius = std::min(max_radius, 0.5 * std::min(before, after) / std::tan(0.5 * std::abs(turn)));
    }
    from = point;
  }
  return max_radius;
}

}  // namespace

double default_corner_radius(const Model& model) {
  const Section& pipe = model.pipe_section();
  const double hold = model.seabed.friction_lateral * pipe.weight_submerged;
  const double depth = model.description.environment.water_depth;
  const double height = model.description.vessel.stern_shoe_z + model.description.tensioner.z;
  const double suspended_weight = pipe.weight_submerged * depth + pipe.weight_in_air * std::max(0.0, height);
  const double pull = model.description.tensioner.tension.value_or(2.0 * suspended_weight) - suspended_weight;
  // times the diameter: minimum radius, governs where friction and tension require less
  constexpr double kMinRadiusOverDiameter = 100.0;
  const double min_radius = kMinRadiusOverDiameter * pipe.outer_diameter;
  const double held = hold > 0.0 ? std::max(kRouteReserve * pull / hold, min_radius) : min_radius;
  return std::min(held, compute_max_corner_radius(model.description.route.points));
}

LayRoute lay_route(const Model& model) {
  const TensionerDescription& tensioner = model.description.tensioner;
  const Vec3 start = point_from_ramp(model, model.nominal_pose, Vec3(tensioner.x, 0.0, tensioner.z));
  const Vec3 astern = astern_direction(model.nominal_pose);
  const RouteDescription& route = model.description.route;
  if (!route.given()) return {start, astern};
  const double radius = route.corner_radius > 0.0 ? route.corner_radius : default_corner_radius(model);
  return {start, astern, -tensioner.x, route_legs(route, radius)};
}

}  // namespace overbend
