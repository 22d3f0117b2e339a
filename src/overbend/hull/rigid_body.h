/// A rigid body about its centre of gravity, without linearisation: m p'' = F, d/dt (R I R^T omega) = M.
#pragma once

#include "model/description/hydrodynamic_data.h"

namespace overbend {

/// Mass properties of a body.
struct RigidBody {
  double mass = 0.0;            ///< [kg]
  Mat3 inertia = Mat3::Zero();  ///< About the centre of gravity in the body's axes, products included [kg m2].
};

/// Inertia forces conjugate to h (hull/body_kinematics.h) for acceleration `a` at rates `v`, with their derivatives by
/// h, v and a.
struct RigidBodyForce {
  Vec6 force = Vec6::Zero();
  Mat6 by_h = Mat6::Zero(), by_v = Mat6::Zero(), by_a = Mat6::Zero();
};
/// Returns the inertia forces at h, v and a.
RigidBodyForce rigid_body_force(const RigidBody& body, const Vec6& h, const Vec6& v, const Vec6& a);

/// Returns the kinetic energy [J].
double kinetic_energy(const RigidBody& body, const Vec6& h, const Vec6& v);

}  // namespace overbend
