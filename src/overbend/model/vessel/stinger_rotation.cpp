#include "model/vessel/stinger_rotation.h"

#include <cmath>

#include "base/require.h"

namespace overbend {
namespace {

Vec3 place_S(const StingerPoint& point) {
  return {point.x, 0.0, point.z};
}

/// Displacement of a section by the rotation about its hinge.
struct SectionMove {
  Vec3 from_S, to_S;  ///< Hinge before and after [m].
  double angle;       ///< [rad]

  Vec3 point(const Vec3& p_S) const { return to_S + rotated_down(p_S - from_S, angle); }
};

std::vector<SectionMove> moves_to(const std::vector<StingerSection>& sections, const std::vector<double>& angles) {
  std::vector<SectionMove> moves;
  double turned = 0.0;
  for (std::size_t i = 0; i < sections.size(); ++i) {
    const Vec3 hinge_S = sections[i].hinge_S;
    turned += angles[i];
    moves.push_back({hinge_S, i == 0 ? hinge_S : moves.back().point(hinge_S), turned - sections[i].turned});
  }
  return moves;
}

void move_roller(Roller& roller, const SectionMove& move) {
  roller.center_S = move.point(roller.center_S);
  roller.axis_S = rotated_down(roller.axis_S, move.angle);
  roller.normal_S = rotated_down(roller.normal_S, move.angle);
}

void move_box(Supports& supports, SupportBox& box, const SectionMove& move) {
  box.point_S = move.point(box.point_S);
  box.curve_S = move.point(box.curve_S);
  box.direction_S = rotated_down(box.direction_S, move.angle);
  box.normal_S = rotated_down(box.normal_S, move.angle);
  box.inclination += move.angle;
  for (int r = box.first_row; r < box.first_row + box.row_count; ++r) {
    SupportRow& row = supports.rows[static_cast<std::size_t>(r)];
    row.point_S = move.point(row.point_S);
    for (int i = row.first_roller; i < row.first_roller + row.roller_count; ++i) {
      move_roller(supports.rollers[static_cast<std::size_t>(i)], move);
    }
  }
}

}  // namespace

Vec3 rotated_down(const Vec3& d_S, double angle) {
  const double c = std::cos(angle), s = std::sin(angle);
  return {c * d_S.x() + s * d_S.z(), d_S.y(), c * d_S.z() - s * d_S.x()};
}

std::vector<double> prescribed_angles(const SupportsDescription& supports) {
  std::vector<double> angles;
  for (const StingerSectionDescription& section : supports.sections) angles.push_back(section.angle.value_or(0.0));
  return angles;
}

std::vector<StingerSection> drawn_sections(const SupportsDescription& supports) {
  std::vector<StingerSection> sections;
  for (const StingerSectionDescription& section : supports.sections) {
    sections.push_back({place_S(section.hinge), 0.0, 0.0});
  }
  return sections;
}

void rotate_stinger(Supports& supports, const std::vector<double>& angles) {
  require(angles.size() == supports.sections.size(), "each section of the stinger has its angle");
  const std::vector<SectionMove> moves = moves_to(supports.sections, angles);
  double turned = 0.0;
  for (std::size_t i = 0; i < moves.size(); ++i) {
    turned += angles[i];
    supports.sections[i] = {moves[i].to_S, angles[i], turned};
  }
  for (SupportBox& box : supports.boxes) {
    if (box.section < 0) continue;
    const SectionMove& move = moves[static_cast<std::size_t>(box.section)];
    if (move.angle != 0.0 || move.to_S != move.from_S) move_box(supports, box, move);
  }
}

Vec3 point_on_section(const StingerSectionDescription& described, const StingerSection& section,
                      const StingerPoint& drawn, double y) {
  const Vec3 arm_S = rotated_down(place_S(drawn) - place_S(described.hinge), section.turned);
  return section.hinge_S + arm_S + Vec3(0.0, y, 0.0);
}

}  // namespace overbend
