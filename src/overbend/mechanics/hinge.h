/// A rigid body on a hinge that another carries: its motion follows from the carrier's and from one angle.
#pragma once

#include "mechanics/vessel_motion.h"

namespace overbend {

/// The hinge in the frame of the carrier. At the angle `rest` the body's frame coincides with the carrier's, so that
/// points of both are told in one frame.
struct Hinge {
  Vec3 place_V = Vec3::Zero();   ///< [m]
  Vec3 axis_V = -Vec3::UnitY();  ///< Unit vector: to starboard, about which the tip of a stinger goes down.
  double rest = 0.0;             ///< [rad]
};

/// Angle of a hinge with its rates [rad, rad/s, rad/s2].
struct HingeMotion {
  double angle = 0.0, rate = 0.0, acceleration = 0.0;
};

/// Motion of a body on a hinge of `carrier`, of the origin of its own frame.
RigidMotion hinged_motion(const RigidMotion& carrier, const Hinge& hinge, const HingeMotion& turn);

}  // namespace overbend
