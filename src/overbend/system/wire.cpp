#include "system/wire.h"

#include <algorithm>

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
  pull.stiffness = axial * by_stretch + pull.tension / pull.span * (Mat3::Identity() - by_stretch);
  return pull;
}

}  // namespace overbend
