/// A rigid body that moves freely: its six coordinates and what they say of its points.
///
/// h = (x, y, z, phi, theta, psi): place of the body's reference point in W [m] and Tait-Bryan angles [rad] with
/// R = Rz(psi) Ry(theta) Rx(phi); roll starboard down, pitch bow down, yaw anticlockwise from W's x axis and without
/// limit. Rates v and accelerations a are the time derivatives of h.
///
/// The axes e_phi = Rz Ry x, e_theta = Rz y, e_psi = z turn with the angles outside their own only, so that every
/// derivative of r = R f by the angles is a row of cross products, the outermost angle first:
///     d2 r / d theta_i d theta_j = e_j x (e_i x r),   i <= j.
#pragma once

#include "base/vec.h"
#include "mechanics/vessel_motion.h"
#include "model/description/hydrodynamic_data.h"

namespace overbend {

using Mat36 = Eigen::Matrix<double, 3, 6>;

/// A horizontal rotation by `angle`.
Mat3 turned_about_z(double angle);

struct BodyPose {
  Vec3 place = Vec3::Zero();  ///< Of the reference point, W [m].
  Mat3 R = Mat3::Identity();  ///< Axes of the body in W.
  Mat3 E = Mat3::Identity();  ///< Columns: axes of roll, pitch and yaw in W; omega = E (phi', theta', psi').
};
BodyPose pose_of(const Vec6& h);

/// The coordinates of a body whose axes stand as R; |theta| < 90 deg, psi in (-pi, pi].
Vec6 coordinates_of(const Vec3& place, const Mat3& R);

/// Pose with rates and accelerations.
struct BodyMotion {
  BodyPose pose;
  Vec6 h = Vec6::Zero(), v = Vec6::Zero(), a = Vec6::Zero();  ///< Coordinates, rates, accelerations.
  Vec3 omega = Vec3::Zero(), alpha = Vec3::Zero();            ///< Angular velocity and acceleration, W [rad/s, rad/s2].
};
BodyMotion motion_of(const Vec6& h, const Vec6& v, const Vec6& a);

/// A point of the body. `arm` [m]: from the reference point in the body's axes.
struct BodyPoint {
  Vec3 arm = Vec3::Zero();                                    ///< R f, in W [m].
  Vec3 place = Vec3::Zero();                                  ///< W [m].
  Vec3 velocity = Vec3::Zero(), acceleration = Vec3::Zero();  ///< W [m/s], [m/s2].
};
BodyPoint point_of(const BodyMotion& body, const Vec3& arm);

/// Change of the place of a point with h: [ I | -[R f]x E ]; `arm_W` = R f [m]. Velocity is J v.
Mat36 point_jacobian(const BodyPose& pose, const Vec3& arm_W);

/// Exact derivatives of a point's motion by h, v and a (rows of W).
struct PointDerivatives {
  Mat36 place_h = Mat36::Zero();         ///< The jacobian J; also d velocity / dv and d acceleration / da.
  Mat36 velocity_h = Mat36::Zero();      ///< At constant v.
  Mat36 acceleration_h = Mat36::Zero();  ///< At constant v and a.
  Mat36 acceleration_v = Mat36::Zero();
};
PointDerivatives point_derivatives(const BodyMotion& body, const Vec3& arm_W);

/// The same for a direction d fixed in the body: columns of the translations are zero.
PointDerivatives direction_derivatives(const BodyMotion& body, const Vec3& direction_W);

/// Forces conjugate to h of a force at a point: J^T F (moments times E^T). [N, N m]
Vec6 generalised_force(const BodyPose& pose, const Vec3& arm_W, const Vec3& force_W);
/// Of a moment in W.
Vec6 generalised_moment(const BodyPose& pose, const Vec3& moment_W);

/// Derivative by h of the above for a force that keeps its components in W. Symmetric.
Mat6 generalised_force_slope(const BodyPose& pose, const Vec3& arm_W, const Vec3& force_W);
/// For a moment that keeps its components in W.
Mat6 generalised_moment_slope(const BodyPose& pose, const Vec3& moment_W);

/// As the prescribed motion of a vessel is given: of V's origin, `reference_V` being the reference point in V, with the
/// freedoms counted from the coordinates `drawn`; surge and sway along the drawn heading.
RigidMotion rigid_motion(const BodyMotion& body, const Vec3& reference_V, const Vec6& drawn);

/// Surge, sway, heave [m], roll, pitch, yaw [rad] of h from the coordinates `drawn`; surge and sway along the drawn
/// heading. Yaw is not wrapped.
Vec6 freedoms_from(const Vec6& h, const Vec6& drawn);

}  // namespace overbend
