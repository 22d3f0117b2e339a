#include "moorings/catenary_line.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/require.h"

namespace overbend {
namespace {

/// A point closer than this to the end of a segment is at that end [m].
constexpr double kSamePlace = 1e-6;

CatenaryPoint catenary_point(const LinePointDescription& from, std::size_t behind, double gravity) {
  CatenaryPoint point;
  point.behind = behind;
  point.pull_up = from.net_force;
  point.shape = from.shape;
  point.tether = from.tether;
  if (from.kind == PointKind::buoy) {
    point.buoyancy = from.net_force + from.mass * gravity;
    const double diameter = std::cbrt(6.0 * from.volume / std::numbers::pi);
    point.height = from.shape == BuoyShape::sphere ? diameter : from.height;
  }
  return point;
}

CatenaryPiece catenary_piece(const LineTypeDescription& type, double length, double bed_friction) {
  return {length, type.weight_in_air, type.weight_submerged, type.axial_stiffness,
          type.friction.value_or(bed_friction)};
}

}  // namespace

double CatenaryLine::length() const {
  double sum = 0.0;
  for (const CatenaryPiece& piece : pieces) sum += piece.length;
  return sum;
}

CatenaryLine catenary_line(const std::vector<LineSegmentDescription>& segments,
                           const std::vector<LinePointDescription>& points, double bed_friction, double gravity) {
  require(!segments.empty(), "a line has a segment");
  std::vector<LinePointDescription> sorted = points;
  std::stable_sort(sorted.begin(), sorted.end(), [](const auto& a, const auto& b) { return a.at < b.at; });
  CatenaryLine line;
  double from = 0.0;
  auto point = sorted.begin();
  for (const LineSegmentDescription& segment : segments) {
    const double to = from + segment.length.value_or(0.0);
    double position = from;
    for (; point != sorted.end() && point->at <= to + kSamePlace; ++point) {
      const double place = std::min(point->at, to);
      if (place > position + kSamePlace) {
        line.pieces.push_back(catenary_piece(segment.type, place - position, bed_friction));
        position = place;
      }
      require(!line.pieces.empty(), "a point is behind the fairlead");
      line.points.push_back(catenary_point(*point, line.pieces.size() - 1, gravity));
    }
    if (to > position + kSamePlace || !segment.length) {
      line.pieces.push_back(catenary_piece(segment.type, to - position, bed_friction));
    }
    from = to;
    if (&segment == &segments.front()) line.first_segment_rest = to - line.pieces.front().length;
  }
  return line;
}

}  // namespace overbend
