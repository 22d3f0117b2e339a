#include "system/wire.h"

#include <algorithm>
#include <cstddef>

#include "moorings/suspended_line.h"

namespace overbend {

WirePull wire_pull(const Wire& wire, const Vec3& first, const Vec3& second) {
  WirePull pull;
  pull.first = first;
  pull.second = second;
  pull.span = (second - first).norm();
  const double stretch = pull.span / wire.length - 1.0;
  pull.tension = wire.held_tension.value_or(std::max(wire.axial_stiffness * stretch, 0.0));
  if (!(pull.tension > 0.0)) return pull;
  const Vec3 along = (second - first) / pull.span;
  const Mat3 by_stretch = along * along.transpose();
  const double axial = wire.held_tension ? 0.0 : wire.axial_stiffness / wire.length;
  pull.force = pull.tension * along;
  pull.on_second = -pull.force;
  pull.stiffness = axial * by_stretch + pull.tension / pull.span * (Mat3::Identity() - by_stretch);
  return pull;
}

namespace {

/// A line far too short for a catenary pulls like a straight wire.
WirePull line_pull(const LineWire& line, const Vec3& first, const Vec3& second) {
  if (!line.catenary) return wire_pull(line.wire, first, second);
  const SuspendedLineForces catenary = suspended_line_forces(*line.catenary, first, second);
  if (!catenary.found) return wire_pull(line.wire, first, second);
  WirePull pull;
  pull.first = first;
  pull.second = second;
  pull.span = (second - first).norm();
  pull.force = line.share * catenary.on_first;
  pull.on_second = line.share * catenary.on_second;
  pull.stiffness = line.share * catenary.stiffness;
  pull.tension = pull.force.norm();
  return pull;
}

}  // namespace

WireEnd wire_end(const Wire& wire, const std::vector<RigidMotion>& bodies) {
  if (wire.first_body == kGround) return {wire.first, Vec3::Zero()};
  const RigidMotion& body = bodies[static_cast<std::size_t>(wire.first_body)];
  const Vec3 arm = body.pose.R_WV * wire.first;
  return {body.pose.p_WV + arm, body.velocity + body.omega.cross(arm)};
}

void add_wire_forces(std::span<const LineWire> wires, std::span<const WireEnd> ends, const double* q, double* residual,
                     BlockTridiagonal* tangent, std::span<WirePull> pulls) {
  for (std::size_t i = 0; i < wires.size(); ++i) {
    const int node = wires[i].node;
    pulls[i] = line_pull(wires[i], ends[i].place, Eigen::Map<const Vec3>(q + 6 * node));
    double* const diag = tangent != nullptr ? tangent->diag(node) : nullptr;
    for (int row = 0; row < 3; ++row) {
      residual[6 * node + row] -= pulls[i].on_second(row);
      for (int k = 0; diag != nullptr && k < 3; ++k) diag[row * kRowWidth + k] += pulls[i].stiffness(row, k);
    }
  }
}

void add_wire_energy(std::span<const LineWire> wires, std::span<const WireEnd> ends, std::span<const WirePull> pulls,
                     LineEnergy& sum, double& power) {
  for (std::size_t i = 0; i < wires.size(); ++i) {
    const Wire& wire = wires[i].wire;
    sum.strain += 0.5 * pulls[i].tension * pulls[i].tension * wire.length / wire.axial_stiffness;
    power -= pulls[i].force.dot(ends[i].velocity);
  }
}

}  // namespace overbend
