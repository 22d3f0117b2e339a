#include "system/wire.h"

namespace overbend {

WirePull wire_pull(const Wire& wire, const Vec3& first, const Vec3& second) {
  WirePull pull;
  pull.first = first;
  pull.second = second;
  pull.span = (second - first).norm();
  const double stretch = pull.span / wire.length - 1.0;
  if (!(stretch > 0.0)) return pull;
  const Vec3 along = (second - first) / pull.span;
  const Mat3 by_stretch = along * along.transpose();
  pull.tension = wire.axial_stiffness * stretch;
  pull.force = pull.tension * along;
  pull.stiffness =
      wire.axial_stiffness / wire.length * by_stretch + pull.tension / pull.span * (Mat3::Identity() - by_stretch);
  return pull;
}

}  // namespace overbend
