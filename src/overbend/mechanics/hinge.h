/// Kinematics of a rigid body hinged to a carrier: its motion follows from the carrier's motion and one angle.
#pragma once

#include "mechanics/vessel_motion.h"

namespace overbend {

/// The hinge in the frame of the carrier. At the angle `rest` the body's frame coincides with the carrier's, so that
/// points of both are given in one frame.
struct Hinge {
  Vec3 place_V = Vec3::Zero();   ///< [m]
  Vec3 axis_V = -Vec3::UnitY();  ///< Unit vector to starboard: a positive rotation lowers the tip of a stinger.
  double rest = 0.0;             ///< [rad]
};

/// Angle of a hinge with its rates [rad, rad/s, rad/s2].
struct HingeMotion {
  double angle = 0.0, rate = 0.0, acceleration = 0.0;
};

/// Returns the motion of a body hinged to `carrier`, at the origin of the body's own frame.
RigidMotion hinged_motion(const RigidMotion& carrier, const Hinge& hinge, const HingeMotion& turn);

}  // namespace overbend
