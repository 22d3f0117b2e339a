/// External forces per unstressed length at a point of the line, plain scalar form: reference for the element kernel,
/// and used for results.
#pragma once

#include "base/vec.h"
#include "mechanics/line_elements.h"

namespace overbend {

/// Forces per length [N/m] in W.
struct PointLoad {
  Vec3 weight = Vec3::Zero(), buoyancy = Vec3::Zero(), current = Vec3::Zero(), seabed = Vec3::Zero();
  double seabed_normal = 0.0;  ///< Magnitude of the normal part [N/m].
  double penetration = 0.0;    ///< Penetration of the underside into the seabed, 0 when clear [m].

  Vec3 sum() const { return weight + buoyancy + current + seabed; }
};

/// Returns the forces at axis position `r` with tangent `a` = dr/ds of element `element`.
PointLoad point_load(const LineElements& elements, const LineEnvironment& env, int element, const Vec3& r,
                     const Vec3& a);

/// Returns the current velocity at height z: linear between the rows of the table, constant beyond [m/s].
Vec3 current_velocity(const LineEnvironment& env, double z);
/// Returns its derivative with z, 0 beyond the ends of the table [1/s].
Vec3 current_slope(const LineEnvironment& env, double z);

}  // namespace overbend
