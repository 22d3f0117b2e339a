#include "statics/initial_shape/cable_shape.h"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "mechanics/element_constants.h"

namespace overbend {
namespace {

constexpr double kMinWeight = 1e-3;  ///< Minimum weight relative to the weight in air; lighter cables get this
                                     ///< weight.
constexpr double kOnBed = 0.02;      ///< An end closer to the bed than this share of the cable's length is treated as
                                     ///< on the bed.

/// Position and vertical force of the catenary at an arc length from the lower end.
struct GuessPoint {
  double x, z, vertical;
};

GuessPoint point_at(const CableShape& c, double s) {
  const double w = c.weight, H = c.horizontal;
  if (c.on_bed > 0.0) {
    const double lifted = std::max(s - c.on_bed, 0.0), v = w * lifted;
    return {std::min(s, c.on_bed) + H / w * std::asinh(v / H) + H * s / c.EA,
            H / w * (std::hypot(1.0, v / H) - 1.0) + 0.5 * v * v / (w * c.EA), v};
  }
  const double low = c.vertical - w * c.length, v = low + w * s;
  return {H / w * (std::asinh(v / H) - std::asinh(low / H)) + H * s / c.EA,
          H / w * (std::hypot(1.0, v / H) - std::hypot(1.0, low / H)) + (low * s + 0.5 * w * s * s) / c.EA, v};
}

/// Point on the bed: along and across the direction to the other end, and the angle from that direction.
struct BowPoint {
  double x, y, turn;
};

/// A slack cable lies on a circular arc, so that no part of it is in compression.
BowPoint bow_at(const CableShape& c, double s) {
  double low = 0.0, high = std::numbers::pi;
  for (int i = 0; i < 60; ++i) {
    const double half = 0.5 * (low + high);
    (std::sin(half) * c.on_bed > half * c.across ? low : high) = half;
  }
  const double half = 0.5 * (low + high), radius = 0.5 * c.on_bed / half, turn = half - s / radius;
  return {radius * (std::sin(half) - std::sin(turn)), radius * (std::cos(turn) - std::cos(half)), turn};
}

void put(std::vector<double>& q, const Vec3& r, const Vec3& t) {
  q.insert(q.end(), {r.x(), r.y(), r.z(), t.x(), t.y(), t.z()});
}

/// If an end of a catenary reverses within less than an element, its tangent makes that element a loop, which Newton's
/// method would tighten and keep. Such a tangent is replaced by the direction of its element.
void align_reversed_ends(std::vector<double>& q) {
  const std::size_t nodes = q.size() / 6;
  for (const std::size_t end : {std::size_t{0}, nodes - 1}) {
    const std::size_t neighbour = end == 0 ? 1 : nodes - 2;
    const Vec3 between = Eigen::Map<const Vec3>(q.data() + 6 * neighbour) - Eigen::Map<const Vec3>(q.data() + 6 * end);
    if (between.norm() == 0.0) continue;
    const Vec3 along = (end == 0 ? 1.0 : -1.0) * between.normalized();
    Eigen::Map<Vec3> t(q.data() + 6 * end + 3);
    if (t.normalized().dot(along) < 0.0) t = t.norm() * along;
  }
}

/// Error of the upper end's position.
Eigen::Vector2d compute_end_error(CableShape& c, bool bed) {
  c.on_bed = bed ? std::max(c.length - c.vertical / c.weight, 0.0) : 0.0;
  const GuessPoint end = point_at(c, c.length);
  return {end.x - c.across, end.z - c.up};
}

bool solve(CableShape& c, bool bed) {
  const double across = std::max(c.across, 1e-3 * c.length);
  const double square = (c.length * c.length - c.up * c.up) / (across * across) - 1.0;
  const double l = square > 0.0 ? std::max(std::sqrt(3.0 * square), 1e-3) : 0.2;
  c.horizontal = std::abs(c.weight * across / (2.0 * l));
  c.vertical = 0.5 * c.weight * (c.up / std::tanh(l) + c.length);
  c.across = across;
  Eigen::Vector2d error = compute_end_error(c, bed);
  for (int i = 0; i < 100; ++i) {
    if (error.norm() < 1e-9 * c.length) return true;
    Eigen::Matrix2d slope;
    for (int k = 0; k < 2; ++k) {
      CableShape moved = c;
      double& force = k == 0 ? moved.horizontal : moved.vertical;
      const double step = 1e-7 * std::hypot(c.horizontal, c.vertical);
      force += step;
      slope.col(k) = (compute_end_error(moved, bed) - error) / step;
    }
    const Eigen::Vector2d step = -slope.partialPivLu().solve(error);
    if (!step.allFinite()) return false;
    const CableShape before = c;
    bool nearer = false;
    double share = 1.0;
    for (int halvings = 0; halvings < 20 && !nearer; ++halvings, share *= 0.5) {
      c.horizontal = before.horizontal + share * step.x();
      c.vertical = before.vertical + share * step.y();
      if (c.horizontal < 0.1 * before.horizontal) continue;
      const Eigen::Vector2d new_error = compute_end_error(c, bed);
      nearer = new_error.norm() < error.norm();
      if (nearer) error = new_error;
    }
    if (!nearer) return false;
  }
  return false;
}

}  // namespace

std::optional<double> CableShape::touchdown() const {
  if (on_bed <= 0.0) return std::nullopt;
  return from_second ? length - on_bed : on_bed;
}

std::vector<double> CableShape::shape(const LineMesh& mesh) const {
  const double side = buoyant ? -1.0 : 1.0;
  std::vector<double> q;
  for (const double from_first : mesh.s) {
    const double s = from_second ? length - from_first : from_first;
    double x = 0.0, z = 0.0, stretch = 1.0;
    Eigen::Vector2d direction;
    if (slack && s < on_bed) {
      const BowPoint point = bow_at(*this, s);
      const Vec3 port = Vec3::UnitZ().cross(ahead);
      const Vec3 r = lower + point.x * ahead + point.y * port,
                 t = std::cos(point.turn) * ahead + std::sin(point.turn) * port;
      put(q, r, from_second ? Vec3(-t) : t);
      continue;
    }
    if (slack) {
      x = across;
      z = s - on_bed;
      direction = {0.0, 1.0};
    } else if (straight) {
      x = across * s / length;
      z = up * s / length;
      direction = Eigen::Vector2d(across, up).normalized();
      stretch = std::hypot(across, up) / length;
    } else {
      const GuessPoint point = point_at(*this, s);
      x = point.x;
      z = point.z;
      const double tension = std::hypot(horizontal, point.vertical);
      direction = Eigen::Vector2d(horizontal, point.vertical) / tension;
      stretch = 1.0 + tension / EA;
    }
    Vec3 r = lower + x * ahead + side * z * Vec3::UnitZ();
    r.z() = std::clamp(r.z(), lowest, highest);
    const Vec3 t = (from_second ? -stretch : stretch) * (direction.x() * ahead + side * direction.y() * Vec3::UnitZ());
    put(q, r, t);
  }
  if (mesh.s.size() > 1) align_reversed_ends(q);
  return q;
}

CableShape make_cable_shape(const Model& model, const CableParts& parts, const Vec3& first, const Vec3& second) {
  CableShape c;
  double softness = 0.0, submerged = 0.0, in_air = 0.0;
  for (const LineSegmentDescription& segment : parts.segments) {
    const double length = segment.length.value();
    c.length += length;
    submerged += length * segment.type.weight_submerged;
    in_air += length * segment.type.weight_in_air;
    softness += length / segment.type.axial_stiffness;
  }
  for (const LinePointDescription& point : parts.points) submerged -= point.net_force;
  c.EA = c.length / softness;
  c.buoyant = submerged < 0.0;
  c.weight = std::max(std::abs(submerged), kMinWeight * in_air) / c.length;
  const bool second_lower = second.z() < first.z();
  c.from_second = second_lower != c.buoyant;
  c.lower = c.from_second ? second : first;
  const Vec3 to_upper = (c.from_second ? first : second) - c.lower;
  c.across = std::hypot(to_upper.x(), to_upper.y());
  c.up = std::abs(to_upper.z());
  if (c.across > 0.0) c.ahead = Vec3(to_upper.x(), to_upper.y(), 0.0) / c.across;
  const double bed = model.seabed.surface.height(c.lower.x(), c.lower.y());
  c.lowest = std::min({bed, first.z(), second.z()});
  if (c.buoyant) c.highest = std::max({0.0, first.z(), second.z()});
  const double height = c.buoyant ? -c.lower.z() : c.lower.z() - bed;
  const bool may_lie = height < kOnBed * c.length;
  if (solve(c, false) && !(may_lie && c.vertical < c.weight * c.length)) return c;
  if (may_lie && solve(c, true)) return c;
  c.across = std::hypot(to_upper.x(), to_upper.y());
  c.slack = may_lie && c.length > c.across + c.up;
  c.straight = !c.slack;
  c.on_bed = c.slack ? c.length - c.up : 0.0;
  return c;
}

}  // namespace overbend
