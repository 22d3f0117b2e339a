#include "statics/equations/equilibrium_target.h"

#include <algorithm>
#include <cmath>

namespace overbend {
namespace {

TargetEquation tension_equation(const Line& line, const LineState& state, double tension) {
  const std::size_t e = line.mesh.length.size() - 1;
  const Eigen::Map<const Vec3> r(state.q.data() + 6 * e + 6), t(state.q.data() + 6 * e + 9);
  const LineElements& elements = line.elements;
  const double pressure = elements.pressure_constant[e] + elements.pressure_slope[e] * r.z() +
                          elements.pressure_external[e] * std::max(-r.z(), 0.0);
  const double found = elements.EA[e] * (t.norm() - 1.0) + pressure;
  return {line.mesh.elements(), true, elements.EA[e] * t.normalized(), found - tension};
}

}  // namespace

TargetEquation target_equation(const EquilibriumTarget& target, const LayPlane& plane, const Line& line,
                               const LineState& state) {
  if (target.kind == EquilibriumTarget::Kind::top_tension) return tension_equation(line, state, target.value);
  const Eigen::Map<const Vec3> far(state.q.data());
  return {0, false, plane.astern_W, (far - plane.tensioner_W).dot(plane.astern_W) - target.value};
}

double relative_error(const EquilibriumTarget& target, const Line& line, double error) {
  const bool tension = target.kind == EquilibriumTarget::Kind::top_tension;
  return std::abs(error) / (tension ? std::min(line.force_scale, target.value) : line.mesh.total_length());
}

}  // namespace overbend
