#include "mechanics/hinge.h"

#include <Eigen/Geometry>

namespace overbend {

RigidMotion hinged_motion(const RigidMotion& carrier, const Hinge& hinge, const HingeMotion& turn) {
  const Mat3& base = carrier.pose.R_WV;
  const Vec3 axis = base * hinge.axis_V;
  const PointMotion hinge_point = point_motion(carrier, hinge.place_V);
  RigidMotion body;
  body.pose.R_WV = base * Eigen::AngleAxisd(turn.angle - hinge.rest, hinge.axis_V).toRotationMatrix();
  const Vec3 to_origin = -(body.pose.R_WV * hinge.place_V);
  body.pose.p_WV = hinge_point.place + to_origin;
  body.omega = carrier.omega + turn.rate * axis;
  body.alpha = carrier.alpha + turn.acceleration * axis + turn.rate * carrier.omega.cross(axis);
  body.velocity = hinge_point.velocity + body.omega.cross(to_origin);
  body.acceleration =
      hinge_point.acceleration + body.alpha.cross(to_origin) + body.omega.cross(body.omega.cross(to_origin));
  body.freedoms = carrier.freedoms;
  return body;
}

}  // namespace overbend
