#include "mechanics/hinge.h"

#include <Eigen/Geometry>

namespace overbend {

RigidMotion hinged_motion(const RigidMotion& carrier, const Hinge& hinge, const HingeMotion& turn) {
  const Mat3& base = carrier.pose.R_WV;
  const Vec3 axis = base * hinge.axis_V;
  const PointMotion at = point_motion(carrier, hinge.place_V);
  RigidMotion own;
  own.pose.R_WV = base * Eigen::AngleAxisd(turn.angle - hinge.rest, hinge.axis_V).toRotationMatrix();
  const Vec3 to_origin = -(own.pose.R_WV * hinge.place_V);
  own.pose.p_WV = at.place + to_origin;
  own.omega = carrier.omega + turn.rate * axis;
  own.alpha = carrier.alpha + turn.acceleration * axis + turn.rate * carrier.omega.cross(axis);
  own.velocity = at.velocity + own.omega.cross(to_origin);
  own.acceleration = at.acceleration + own.alpha.cross(to_origin) + own.omega.cross(own.omega.cross(to_origin));
  own.freedoms = carrier.freedoms;
  return own;
}

}  // namespace overbend
