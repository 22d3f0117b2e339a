#include "hull/rigid_body.h"

#include <cmath>

namespace overbend {
namespace {

/// Angular velocity in the body's axes is W (phi', theta', psi'); W depends on phi and theta only.
struct BodyRates {
  Mat3 W, by_phi, by_theta;
  Mat3 by_phi_phi, by_phi_theta, by_theta_theta;
};

BodyRates body_rates(double phi, double theta) {
  const double cx = std::cos(phi), sx = std::sin(phi), cy = std::cos(theta), sy = std::sin(theta);
  BodyRates r;
  r.W << 1.0, 0.0, -sy, 0.0, cx, sx * cy, 0.0, -sx, cx * cy;
  r.by_phi << 0.0, 0.0, 0.0, 0.0, -sx, cx * cy, 0.0, -cx, -sx * cy;
  r.by_theta << 0.0, 0.0, -cy, 0.0, 0.0, -sx * sy, 0.0, 0.0, -cx * sy;
  r.by_phi_phi << 0.0, 0.0, 0.0, 0.0, -cx, -sx * cy, 0.0, sx, -cx * cy;
  r.by_phi_theta << 0.0, 0.0, 0.0, 0.0, 0.0, -cx * sy, 0.0, 0.0, sx * sy;
  r.by_theta_theta << 0.0, 0.0, sy, 0.0, 0.0, -sx * cy, 0.0, 0.0, -cx * cy;
  return r;
}

}  // namespace

RigidBodyForce rigid_body_force(const RigidBody& body, const Vec6& h, const Vec6& v, const Vec6& a) {
  const BodyRates r = body_rates(h(3), h(4));
  const Vec3 rate = v.tail<3>(), acceleration = a.tail<3>();
  const Mat3& I = body.inertia;
  const Mat3 W_t = r.by_phi * rate(0) + r.by_theta * rate(1);
  const Vec3 omega = r.W * rate, alpha = r.W * acceleration + W_t * rate, spin = I * omega;
  const Vec3 moment = I * alpha + omega.cross(spin);
  const Mat3 gyration = cross_matrix(omega) * I - cross_matrix(spin);  // of the moment by omega

  RigidBodyForce out;
  out.force << body.mass * a.head<3>(), r.W.transpose() * moment;
  out.by_a.topLeftCorner<3, 3>() = body.mass * Mat3::Identity();
  out.by_a.bottomRightCorner<3, 3>() = r.W.transpose() * I * r.W;

  Mat3 alpha_v = W_t;
  alpha_v.col(0) += r.by_phi * rate;
  alpha_v.col(1) += r.by_theta * rate;
  out.by_v.bottomRightCorner<3, 3>() = r.W.transpose() * (I * alpha_v + gyration * r.W);

  const Mat3* first[2] = {&r.by_phi, &r.by_theta};
  const Mat3* second[2][2] = {{&r.by_phi_phi, &r.by_phi_theta}, {&r.by_phi_theta, &r.by_theta_theta}};
  for (int k = 0; k < 2; ++k) {
    const Mat3& W_k = *first[k];
    const Mat3 W_tk = *second[0][k] * rate(0) + *second[1][k] * rate(1);
    const Vec3 alpha_k = W_k * acceleration + W_tk * rate;
    const Vec3 moment_k = I * alpha_k + gyration * (W_k * rate);
    out.by_h.block<3, 1>(3, 3 + k) = W_k.transpose() * moment + r.W.transpose() * moment_k;
  }
  return out;
}

double kinetic_energy(const RigidBody& body, const Vec6& h, const Vec6& v) {
  const Vec3 omega = body_rates(h(3), h(4)).W * v.tail<3>();
  return 0.5 * body.mass * v.head<3>().squaredNorm() + 0.5 * omega.dot(body.inertia * omega);
}

}  // namespace overbend
