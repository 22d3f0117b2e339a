#include "system/free_body.h"

namespace overbend {

Mat3 cross_matrix(const Vec3& a) {
  Mat3 m;
  m << 0.0, -a.z(), a.y(), a.z(), 0.0, -a.x(), -a.y(), a.x(), 0.0;
  return m;
}

RigidMotion rigid_motion(const FreeBody& body, const HullState& at) {
  return rigid_motion(motion_of(at.h, at.v, at.acc), body.reference_V, body.drawn);
}

Mat36 point_rows(const BodyPose& pose, const Vec3& r) {
  return point_jacobian(pose, r - pose.place);
}

Mat36 vector_rows(const BodyPose& pose, const Vec3& t) {
  Mat36 rows;
  rows << Mat3::Zero(), -cross_matrix(t) * pose.E;
  return rows;
}

}  // namespace overbend
