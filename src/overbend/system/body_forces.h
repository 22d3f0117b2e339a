/// Loads of lines and wires on a body.
#pragma once

#include "system/assembly.h"

namespace overbend {

/// Force and moment about a point.
struct ForceAndMoment {
  Vec3 force = Vec3::Zero(), moment = Vec3::Zero();  ///< [N], [N m]
};

/// Returns the load of the ends of lines and wires on a body, about its origin, W, at the last evaluated state. Does
/// not allocate.
ForceAndMoment force_on_body(const Assembly& assembly, const SystemState& state, int body);

}  // namespace overbend
