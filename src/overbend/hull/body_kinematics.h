/// Kinematics of a free rigid body: its six coordinates and the motion of its points.
#pragma once

#include "base/vec.h"
#include "mechanics/vessel_motion.h"
#include "model/description/hydrodynamic_data.h"

namespace overbend {

using Mat36 = Eigen::Matrix<double, 3, 6>;

/// Returns the rotation by `angle` [rad] about z.
Mat3 turned_about_z(double angle);

/// Position and orientation of a body.
struct BodyPose {
  Vec3 place = Vec3::Zero();  ///< Position of the reference point, W [m].
  Mat3 R = Mat3::Identity();  ///< Axes of the body in W.
  Mat3 E = Mat3::Identity();  ///< Columns: axes of roll, pitch and yaw in W; omega = E (phi', theta', psi').
};
/// Returns the pose for coordinates h.
BodyPose make_pose(const Vec6& h);

/// Returns the coordinates of a body with axes R; |theta| < 90 deg, psi in (-pi, pi].
Vec6 make_coordinates(const Vec3& place, const Mat3& R);

/// Pose with rates and accelerations.
struct BodyMotion {
  BodyPose pose;
  Vec6 h = Vec6::Zero(), v = Vec6::Zero(), a = Vec6::Zero();  ///< Coordinates, rates, accelerations.
  Vec3 omega = Vec3::Zero(), alpha = Vec3::Zero();            ///< Angular velocity and acceleration, W [rad/s, rad/s2].
};
/// Returns the motion for coordinates h, rates v and accelerations a.
BodyMotion make_body_motion(const Vec6& h, const Vec6& v, const Vec6& a);

/// Motion of a body-fixed point. `arm` [m]: from the reference point in the body's axes.
struct BodyPoint {
  Vec3 arm = Vec3::Zero();                                    ///< R f, in W [m].
  Vec3 place = Vec3::Zero();                                  ///< W [m].
  Vec3 velocity = Vec3::Zero(), acceleration = Vec3::Zero();  ///< W [m/s], [m/s2].
};
/// Returns the motion of a body-fixed point.
BodyPoint make_body_point(const BodyMotion& body, const Vec3& arm);

/// Returns the derivative of a point's position by h: [ I | -[R f]x E ]; `arm_W` = R f [m]. Velocity is J v.
Mat36 point_jacobian(const BodyPose& pose, const Vec3& arm_W);

/// Exact derivatives of a point's motion by h, v and a (rows of W).
struct PointDerivatives {
  Mat36 place_h = Mat36::Zero();         ///< The jacobian J; also d velocity / dv and d acceleration / da.
  Mat36 velocity_h = Mat36::Zero();      ///< At constant v.
  Mat36 acceleration_h = Mat36::Zero();  ///< At constant v and a.
  Mat36 acceleration_v = Mat36::Zero();
};
/// Returns the derivatives for the point with arm `arm_W` = R f [m].
PointDerivatives point_derivatives(const BodyMotion& body, const Vec3& arm_W);

/// The same for a body-fixed direction d: columns of the translations are zero.
PointDerivatives direction_derivatives(const BodyMotion& body, const Vec3& direction_W);

/// Returns the forces conjugate to h of a force at a point: J^T F (moments times E^T). [N, N m]
Vec6 generalised_force(const BodyPose& pose, const Vec3& arm_W, const Vec3& force_W);
/// The same for a moment in W.
Vec6 generalised_moment(const BodyPose& pose, const Vec3& moment_W);

/// Returns the derivative by h of the above for a force with constant components in W. Symmetric.
Mat6 generalised_force_slope(const BodyPose& pose, const Vec3& arm_W, const Vec3& force_W);
/// The same for a moment with constant components in W.
Mat6 generalised_moment_slope(const BodyPose& pose, const Vec3& moment_W);

/// Returns the motion in the form of a prescribed vessel motion: of V's origin, `reference_V` being the reference point
/// in V, with the freedoms counted from the coordinates `drawn`; surge and sway along the nominal heading.
RigidMotion rigid_motion(const BodyMotion& body, const Vec3& reference_V, const Vec6& drawn);

/// Returns surge, sway, heave [m], roll, pitch, yaw [rad] of h from the coordinates `drawn`; surge and sway along the
/// nominal heading. Yaw is not wrapped.
Vec6 freedoms_from(const Vec6& h, const Vec6& drawn);

}  // namespace overbend
