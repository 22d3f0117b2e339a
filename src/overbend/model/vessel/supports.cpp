#include "model/vessel/supports.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "model/description/description.h"
#include "model/pipe/contact_stiffness.h"
#include "model/vessel/stinger_rotation.h"

namespace overbend {
namespace {

using Vec2 = Eigen::Vector2d;

const Vec3 kPort_S(0.0, -1.0, 0.0);

double dip(const Vec2& chord) {
  return std::atan2(-chord.y(), chord.x());
}

/// Tangents at three points of the circle through them: the tangent-chord angle is half that of the arc.
struct ThreePointTangents {
  double first, middle, last;
};

ThreePointTangents circle_tangents(const Vec2& a, const Vec2& b, const Vec2& c) {
  const Vec2 ab = b - a;
  const Vec2 bc = c - b;
  // The two tangent-chord angles add up to the turn; their sines are in the ratio of the chords.
  const double turn = dip(bc) - dip(ab);
  const double half_ab = std::atan2(ab.norm() * std::sin(turn), bc.norm() + ab.norm() * std::cos(turn));
  const double half_bc = turn - half_ab;
  return {dip(ab) - half_ab, dip(ab) + half_ab, dip(bc) + half_bc};
}

struct RowFrame {
  Vec3 point_S, normal_S;
};

Roller bottom_roller(const RollerKindDescription& kind, const RowFrame& row) {
  Roller roller;
  roller.position = RollerPosition::bottom;
  roller.radius = kind.bottom.radius;
  roller.face = kind.bottom.face;
  roller.axis_S = kPort_S;
  roller.normal_S = row.normal_S;
  roller.center_S = row.point_S - roller.radius * row.normal_S;
  return roller;
}

/// A side roller is inclined outwards by its angle from horizontal; its distance from the centred pipe is its
/// clearance.
Roller side_roller(const SideRollerDescription& side, const RowFrame& row, double pipe_radius,
                   RollerPosition position) {
  const double outward = position == RollerPosition::port ? 1.0 : -1.0;
  const Vec3 out_S = outward * kPort_S;
  Roller roller;
  roller.position = position;
  roller.radius = side.radius;
  roller.face = side.face;
  roller.axis_S = std::cos(side.angle) * out_S + std::sin(side.angle) * row.normal_S;
  roller.normal_S = -std::sin(side.angle) * out_S + std::cos(side.angle) * row.normal_S;
  const Vec3 pipe_axis_S = row.point_S + pipe_radius * row.normal_S;
  roller.center_S = pipe_axis_S - (pipe_radius + side.clearance + side.radius) * roller.normal_S;
  return roller;
}

void add_row(Supports& supports, const RollerKindDescription& kind, const RowFrame& frame, double pipe_radius, int box,
             double from_top) {
  SupportRow row;
  row.box = box;
  row.from_top = from_top;
  row.point_S = frame.point_S;
  row.first_roller = static_cast<int>(supports.rollers.size());
  std::vector<Roller> rollers{bottom_roller(kind, frame)};
  if (kind.sides) {
    rollers.push_back(side_roller(*kind.sides, frame, pipe_radius, RollerPosition::port));
    rollers.push_back(side_roller(*kind.sides, frame, pipe_radius, RollerPosition::starboard));
  }
  row.roller_count = static_cast<int>(rollers.size());
  for (Roller& roller : rollers) {
    roller.box = box;
    roller.row = static_cast<int>(supports.rows.size());
    roller.stiffness = kind.stiffness.value_or(0.0);
    roller.is_stiffness_given = kind.stiffness.has_value();
    roller.default_stiffness = kind.default_stiffness;
    roller.structure_stiffness = kind.structure_stiffness.value_or(kRollerStructure);
    roller.friction_axial = kind.friction_axial;
    roller.friction_lateral = kind.friction_lateral;
    roller.restitution = kind.restitution;
    roller.damping = kind.damping;
    roller.tangential_stiffness = kind.tangential_stiffness.value_or(0.0);
    supports.rollers.push_back(roller);
  }
  supports.rows.push_back(row);
}

}  // namespace

std::vector<double> curve_inclinations(const std::vector<Vec2>& points, double fallback) {
  const std::size_t n = points.size();
  if (n < 2) {
    return std::vector<double>(n, fallback);
  }
  if (n == 2) {
    return std::vector<double>(2, dip(points[1] - points[0]));
  }
  std::vector<double> inclinations(n);
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t middle = std::clamp<std::size_t>(i, 1, n - 2);
    const ThreePointTangents tangents = circle_tangents(points[middle - 1], points[middle], points[middle + 1]);
    inclinations[i] = i < middle ? tangents.first : (i > middle ? tangents.last : tangents.middle);
  }
  return inclinations;
}

RollerKindDescription gap_spring(const RollerKindDescription& kind) {
  RollerKindDescription spring = kind;
  spring.bottom.face = kGapSpringReach;
  if (spring.sides) {
    spring.sides->face = kGapSpringReach;
    spring.sides->angle = 0.5 * std::numbers::pi;
  }
  spring.friction_axial = spring.friction_lateral = 0.0;
  spring.restitution = 1.0;
  return spring;
}

Supports place_supports(const Description& description, double pipe_radius) {
  return place_supports(description, [=](double /*from_top*/) { return pipe_radius; });
}

Supports place_supports(const Description& description, const std::function<double(double)>& pipe_radius) {
  const std::vector<BoxDescription>& boxes = description.supports.boxes;
  std::vector<Vec2> points;
  for (const BoxDescription& box : boxes) {
    points.emplace_back(box.x, box.z);
  }
  const std::vector<double> curve = curve_inclinations(points, description.tensioner.incline);

  Supports supports;
  supports.sections = drawn_sections(description.supports);
  const bool hinged = !supports.sections.empty();
  double from_top = 0.0;
  Vec3 last_S(description.tensioner.x, 0.0, description.tensioner.z);
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    const BoxDescription& described = boxes[i];
    SupportBox box;
    box.name = described.name;
    box.structure = described.structure;
    box.section = described.structure == Structure::stinger && hinged ? described.section : -1;
    box.length = described.length;
    box.inclination = described.incline.value_or(curve[i]);
    box.direction_S = Vec3(std::cos(box.inclination), 0.0, -std::sin(box.inclination));
    box.normal_S = Vec3(std::sin(box.inclination), 0.0, std::cos(box.inclination));
    const Vec3 curve_normal_S(std::sin(curve[i]), 0.0, std::cos(curve[i]));
    box.curve_S = Vec3(described.x, 0.0, described.z);
    box.point_S = box.curve_S + described.offset * curve_normal_S;
    box.first_row = static_cast<int>(supports.rows.size());
    const bool springs = description.supports.contact == SupportContact::gap_springs;
    box.row_count = springs ? 1 : described.rows;
    const auto kind = std::find_if(description.rollers.begin(), description.rollers.end(),
                                   [&](const RollerKindDescription& k) { return k.name == described.roller; });
    for (int row = 0; row < box.row_count && kind != description.rollers.end(); ++row) {
      const double along = ((row + 0.5) / box.row_count - 0.5) * described.length;
      const RowFrame frame{box.point_S + along * box.direction_S, box.normal_S};
      from_top += (frame.point_S - last_S).norm();
      last_S = frame.point_S;
      add_row(supports, springs ? gap_spring(*kind) : *kind, frame, pipe_radius(from_top), static_cast<int>(i),
              from_top);
    }
    supports.boxes.push_back(box);
  }
  if (hinged) rotate_stinger(supports, prescribed_angles(description.supports));
  return supports;
}

}  // namespace overbend
