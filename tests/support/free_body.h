/// A small free body for problems that are no lay: a rigid body on linear springs, its ends of lines, its rollers.
#pragma once

#include "support/moving_rod.h"
#include "system/free_body.h"

namespace overbend::testing {

/// Mass about its centre of gravity, held to its drawn coordinates by springs and dashpots.
struct SpringBody {
  RigidBody body{40.0, Mat3(Vec3(30.0, 55.0, 70.0).asDiagonal())};
  Vec6 stiffness = Vec6::Zero(), damping = Vec6::Zero();  ///< [N/m, N m], [N s/m, N m s]
  Vec6 drawn = Vec6::Zero();
  Vec6 pull = Vec6::Zero();  ///< Constant, conjugate to h [N, N m].
};

/// Springs act on the coordinates; by themselves they have a potential, so that energy can be followed.
inline FreeBody free_body(const SpringBody& springs, const Vec3& reference_V = Vec3::Zero()) {
  FreeBody free;
  free.reference_V = reference_V;
  free.drawn = springs.drawn;
  free.force_scale = springs.body.mass * kGravity;
  free.inertia << Vec3::Constant(springs.body.mass), springs.body.inertia.diagonal();
  free.balance = [springs](const HullState& at, const HullState& /*before*/, const Weights& weights, double /*time*/,
                           HullBalance& out) {
    const RigidBodyForce inertia = rigid_body_force(springs.body, at.h, at.v, at.acc);
    out.residual = inertia.force + springs.stiffness.cwiseProduct(at.h - springs.drawn) +
                   springs.damping.cwiseProduct(at.v) - springs.pull;
    out.tangent = inertia.by_h + weights.velocity * inertia.by_v + weights.acceleration * inertia.by_a;
    out.tangent.diagonal() += springs.stiffness + weights.velocity * springs.damping;
  };
  free.energy = [springs](const HullState& at, double /*time*/) {
    const Vec6 away = at.h - springs.drawn;
    BodyEnergy energy;
    energy.kinetic = kinetic_energy(springs.body, at.h, at.v);
    energy.stored = 0.5 * away.dot(springs.stiffness.cwiseProduct(away)) - springs.pull.dot(away);
    energy.power = -at.v.dot(springs.damping.cwiseProduct(at.v));
    return energy;
  };
  return free;
}

/// Holds an end of a line to body 0 at a point of its frame.
inline void hold_on_body(Attachment& end, const Vec3& place_V, const Vec3& direction_V = Vec3::UnitX()) {
  end.body = 0;
  end.place = place_V;
  end.direction = direction_V;
  end.hold_place = true;
}

/// What stands around lines on free bodies: nothing that moves by itself.
inline SurroundingsAt still(const System& system) {
  return [&system](double, Surroundings& now) { lead_attachments(system, now); };
}

}  // namespace overbend::testing
