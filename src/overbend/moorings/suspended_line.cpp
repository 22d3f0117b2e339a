#include "moorings/suspended_line.h"

#include <algorithm>

#include "base/ranges.h"

namespace overbend {
namespace {

/// Forces on both ends, seen from the upper end, and the stiffness of the force on it.
struct UpperEndForces {
  bool found = false;
  Vec3 on_upper = Vec3::Zero(), on_lower = Vec3::Zero();
  Mat3 stiffness = Mat3::Zero();
};

UpperEndForces solve_from_upper_end(const CatenaryLine& line, const Vec3& upper, const Vec3& lower) {
  constexpr double kPlumb = 1e-6;  // relative to the length
  const Vec3 level(lower.x() - upper.x(), lower.y() - upper.y(), 0.0);
  const double min_distance = kPlumb * line.length(), distance = std::max(level.norm(), min_distance);
  const Vec3 along = level.norm() > min_distance ? Vec3(level / level.norm()) : Vec3::UnitX(), up = Vec3::UnitZ();
  CatenarySite site;
  site.fairlead_z = upper.z();
  site.anchor_z = lower.z();
  site.has_bed = false;
  const CatenarySolution solution = solve_catenary(line, site, distance);
  UpperEndForces out;
  out.found = solution.error == CatenaryError::none;
  if (!out.found) return out;
  out.on_upper = solution.pull * along - solution.sink * up;
  out.on_lower = -solution.anchor_pull * along + solution.anchor_rise * up;
  const Eigen::Matrix2d& k = solution.stiffness;  // of (pull, sink) by (distance, height)
  const Mat3 by_distance = along * along.transpose();
  out.stiffness = k(0, 0) * by_distance +
                  solution.pull / distance * (Mat3(Vec3(1.0, 1.0, 0.0).asDiagonal()) - by_distance) -
                  k(0, 1) * along * up.transpose() - k(1, 0) * up * along.transpose() + k(1, 1) * up * up.transpose();
  return out;
}

}  // namespace

SuspendedLineForces suspended_line_forces(const CatenaryLine& line, const Vec3& first, const Vec3& second) {
  if (first.z() >= second.z()) {
    const UpperEndForces forces = solve_from_upper_end(line, first, second);
    return {forces.found, forces.on_upper, forces.on_lower, forces.stiffness};
  }
  CatenaryLine turned = line;
  ranges::reverse(turned.pieces);
  const UpperEndForces forces = solve_from_upper_end(turned, second, first);
  return {forces.found, forces.on_lower, forces.on_upper, forces.stiffness};
}

}  // namespace overbend
