/// Motion of the vessel as a rigid body.
#pragma once

#include <array>

#include "mechanics/build_up.h"
#include "model/model.h"

namespace overbend {

/// Pose with its rates, W.
struct RigidMotion {
  VesselPose pose;
  Vec3 velocity = Vec3::Zero(), acceleration = Vec3::Zero();  ///< Of the vessel's origin [m/s], [m/s2].
  Vec3 omega = Vec3::Zero(), alpha = Vec3::Zero();            ///< Angular velocity and acceleration [rad/s], [rad/s2].
  std::array<double, 6> freedoms{};                           ///< Surge, sway, heave, roll, pitch, yaw [m], [rad].
};

}  // namespace overbend
