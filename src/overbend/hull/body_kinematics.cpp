#include "hull/body_kinematics.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace overbend {
namespace {

/// Second derivatives of an arm by the angles: the axis of the outer angle rotates the derivative by the inner one.
struct ArmCurves {
  std::array<Vec3, 3> first;                  ///< e_i x r
  std::array<std::array<Vec3, 3>, 3> second;  ///< symmetric
};

ArmCurves arm_curves(const Mat3& E, const Vec3& arm_W) {
  ArmCurves c;
  for (int i = 0; i < 3; ++i) c.first[i] = E.col(i).cross(arm_W);
  for (int i = 0; i < 3; ++i) {
    for (int j = i; j < 3; ++j) c.second[i][j] = c.second[j][i] = E.col(j).cross(c.first[i]);
  }
  return c;
}

/// Derivative of second[i][j] by angle k: outermost first.
Vec3 third(const ArmCurves& c, const Mat3& E, int i, int j, int k) {
  int order[3] = {i, j, k};
  std::sort(order, order + 3);
  return E.col(order[2]).cross(c.second[order[0]][order[1]]);
}

/// Derivatives of the motion of a body-fixed vector by the angles, their rates and accelerations.
void add_turning(const BodyMotion& body, const ArmCurves& c, PointDerivatives& out) {
  const Mat3& E = body.pose.E;
  for (int k = 0; k < 3; ++k) {
    Vec3 velocity = Vec3::Zero(), acceleration = Vec3::Zero();
    for (int i = 0; i < 3; ++i) {
      velocity += c.second[i][k] * body.v(3 + i);
      acceleration += c.second[i][k] * body.a(3 + i);
      for (int j = 0; j < 3; ++j) acceleration += third(c, E, i, j, k) * (body.v(3 + i) * body.v(3 + j));
    }
    out.place_h.col(3 + k) = c.first[k];
    out.velocity_h.col(3 + k) = velocity;
    out.acceleration_h.col(3 + k) = acceleration;
    out.acceleration_v.col(3 + k) = 2.0 * velocity;
  }
}

}  // namespace

Mat3 turned_about_z(double angle) {
  const double c = std::cos(angle), s = std::sin(angle);
  Mat3 R;
  R << c, -s, 0.0, s, c, 0.0, 0.0, 0.0, 1.0;
  return R;
}

BodyPose make_pose(const Vec6& h) {
  const double cx = std::cos(h(3)), sx = std::sin(h(3)), cy = std::cos(h(4)), sy = std::sin(h(4));
  const double cz = std::cos(h(5)), sz = std::sin(h(5));
  BodyPose pose;
  pose.place = h.head<3>();
  pose.R << cz * cy, cz * sy * sx - sz * cx, cz * sy * cx + sz * sx,  //
      sz * cy, sz * sy * sx + cz * cx, sz * sy * cx - cz * sx,        //
      -sy, cy * sx, cy * cx;
  pose.E.col(0) = pose.R.col(0);
  pose.E.col(1) = Vec3(-sz, cz, 0.0);
  pose.E.col(2) = Vec3::UnitZ();
  return pose;
}

Vec6 make_coordinates(const Vec3& place, const Mat3& R) {
  Vec6 h;
  h << place, std::atan2(R(2, 1), R(2, 2)), std::asin(std::clamp(-R(2, 0), -1.0, 1.0)), std::atan2(R(1, 0), R(0, 0));
  return h;
}

BodyMotion make_body_motion(const Vec6& h, const Vec6& v, const Vec6& a) {
  BodyMotion body{make_pose(h), h, v, a, Vec3::Zero(), Vec3::Zero()};
  const Mat3& E = body.pose.E;
  body.omega = E * v.tail<3>();
  const Vec3 pitch = v(4) * E.col(1), yaw = v(5) * E.col(2);
  // Axes rotate with the angles outside their own.
  body.alpha = E * a.tail<3>() + yaw.cross(pitch) + (yaw + pitch).cross(v(3) * E.col(0));
  return body;
}

BodyPoint make_body_point(const BodyMotion& body, const Vec3& arm) {
  BodyPoint point;
  point.arm = body.pose.R * arm;
  point.place = body.pose.place + point.arm;
  const Vec3 turning = body.omega.cross(point.arm);
  point.velocity = body.v.head<3>() + turning;
  point.acceleration = body.a.head<3>() + body.alpha.cross(point.arm) + body.omega.cross(turning);
  return point;
}

Mat36 point_jacobian(const BodyPose& pose, const Vec3& arm_W) {
  Mat36 J;
  J.leftCols<3>().setIdentity();
  for (int i = 0; i < 3; ++i) J.col(3 + i) = pose.E.col(i).cross(arm_W);
  return J;
}

PointDerivatives point_derivatives(const BodyMotion& body, const Vec3& arm_W) {
  PointDerivatives out = direction_derivatives(body, arm_W);
  out.place_h.leftCols<3>().setIdentity();
  return out;
}

PointDerivatives direction_derivatives(const BodyMotion& body, const Vec3& direction_W) {
  PointDerivatives out;
  add_turning(body, arm_curves(body.pose.E, direction_W), out);
  return out;
}

Vec6 generalised_force(const BodyPose& pose, const Vec3& arm_W, const Vec3& force_W) {
  Vec6 force;
  force << force_W, pose.E.transpose() * arm_W.cross(force_W);
  return force;
}

Vec6 generalised_moment(const BodyPose& pose, const Vec3& moment_W) {
  Vec6 force;
  force << Vec3::Zero(), pose.E.transpose() * moment_W;
  return force;
}

Mat6 generalised_force_slope(const BodyPose& pose, const Vec3& arm_W, const Vec3& force_W) {
  const ArmCurves c = arm_curves(pose.E, arm_W);
  Mat6 slope = Mat6::Zero();
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) slope(3 + i, 3 + j) = c.second[i][j].dot(force_W);
  }
  return slope;
}

Mat6 generalised_moment_slope(const BodyPose& pose, const Vec3& moment_W) {
  Mat6 slope = Mat6::Zero();
  for (int i = 0; i < 3; ++i) {
    for (int j = i + 1; j < 3; ++j) slope(3 + i, 3 + j) = pose.E.col(j).cross(pose.E.col(i)).dot(moment_W);
  }
  return slope;
}

RigidMotion rigid_motion(const BodyMotion& body, const Vec3& reference_V, const Vec6& drawn) {
  const BodyPoint origin = make_body_point(body, -reference_V);
  RigidMotion m;
  m.pose.p_WV = origin.place;
  m.pose.R_WV = body.pose.R;
  m.velocity = origin.velocity;
  m.acceleration = origin.acceleration;
  m.omega = body.omega;
  m.alpha = body.alpha;
  Eigen::Map<Vec6>(m.freedoms.data()) = freedoms_from(body.h, drawn);
  return m;
}

Vec6 freedoms_from(const Vec6& h, const Vec6& drawn) {
  Vec6 freedoms = h - drawn;
  freedoms.head<3>() = turned_about_z(-drawn(5)) * freedoms.head<3>().eval();
  return freedoms;
}

}  // namespace overbend
