/// What lines and wires do to a body.
#pragma once

#include "system/assembly.h"

namespace overbend {

/// Force and moment about a point.
struct ForceAndMoment {
  Vec3 force = Vec3::Zero(), moment = Vec3::Zero();  ///< [N], [N m]
};

/// Of the ends of lines and wires on a body, about its origin, W, at the state evaluated last. Does not allocate.
ForceAndMoment force_on_body(const Assembly& assembly, const SystemState& state, int body);

}  // namespace overbend
