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
  free.origin = springs.drawn;
  free.force_scale = springs.body.mass * kGravity;
  free.inertia << Vec3::Constant(springs.body.mass), springs.body.inertia.diagonal();
  free.balance = [springs](const HullState& hull_state, const HullState& /*before*/, const Weights& weights,
                           double /*time*/, HullBalance& out) {
    const RigidBodyForce inertia = rigid_body_force(springs.body, hull_state.h, hull_state.v, hull_state.acc);
    out.residual = inertia.force + springs.stiffness.cwiseProduct(hull_state.h - springs.drawn) +
                   springs.damping.cwiseProduct(hull_state.v) - springs.pull;
    out.tangent = inertia.by_h + weights.velocity * inertia.by_v + weights.acceleration * inertia.by_a;
    out.tangent.diagonal() += springs.stiffness + weights.velocity * springs.damping;
  };
  free.energy = [springs](const HullState& hull_state, double /*time*/, const HullBalance& /*step*/) {
    const Vec6 away = hull_state.h - springs.drawn;
    BodyEnergy energy;
    energy.kinetic = kinetic_energy(springs.body, hull_state.h, hull_state.v);
    energy.stored = 0.5 * away.dot(springs.stiffness.cwiseProduct(away)) - springs.pull.dot(away);
    energy.power = -hull_state.v.dot(springs.damping.cwiseProduct(hull_state.v));
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

/// Surroundings of lines on free bodies: nothing that moves by itself.
inline SurroundingsAt surroundings_at_rest(const System& system) {
  return [&system](double, Surroundings& surroundings) { set_attachment_motions(system, surroundings); };
}

/// A body on springs with a heavy cable from the ground, and a rod clamped in it that lies on a roller of the body.
inline System body_with_lines(const SpringBody& springs, double friction = 0.3) {
  System system = rod_system({2e4, 1.0, 3.0, 3.0 * kGravity}, 10.0, 16);
  system.lines.push_back(rod_system({4000.0, 60.0, 1.2, 1.2 * kGravity}, 4.0, 8).lines[0]);
  system.lines[0].on_rollers = false;
  system.lines[0].force_scale = system.lines[1].force_scale = 300.0;
  system.attachments.push_back(system.attachments[1]);
  Attachment &ground = system.attachments[0], &cable = system.attachments[1], &rod = system.attachments[2];
  hold(ground, true, false);
  hold_on_body(cable, Vec3(9.9, 0.0, 0.0));
  hold_on_body(rod, Vec3(14.0, 3.0, 0.5));
  rod.line = 1;
  hold(rod, true, true);
  ContactLaw law;
  law.stiffness = 2e4;
  law.friction_axial = law.friction_lateral = friction;
  law.tangential_stiffness = 2e3;
  BodyRoller roller = roller_under(11.0, 0.01, law);
  roller.center_V += Vec3(0.0, 3.0, 0.5);
  system.bodies[0].rollers = {roller};
  system.bodies[0].cells = endless_cells();
  system.bodies[0].free = free_body(springs, Vec3(12.0, 1.5, 0.0));
  return system;
}

/// Springs for it that let it float.
inline SpringBody floating() {
  SpringBody springs;
  springs.stiffness << 100.0, 100.0, 4000.0, 9000.0, 9000.0, 5000.0;
  springs.drawn << 12.0, 1.5, 0.0, 0.0, 0.0, 0.0;
  springs.pull << 250.0, 60.0, 0.0, 0.0, 0.0, 0.0;
  return springs;
}

/// Its lines straight, the body drawn out of its rest.
inline SystemState drawn_out(const System& system) {
  std::vector<double> rod;
  for (const double s : system.lines[1].mesh.s) rod.insert(rod.end(), {10.1 + s, 3.0, 0.5, 1.0, 0.0, 0.0});
  SystemState state = state_at_rest(system, {straight(system, Vec3::Zero(), Vec3::UnitX(), 0.01), rod}, 0.0);
  state.bodies[0].h.head<3>() = Vec3(12.1, 1.5, 0.0);
  return state;
}

}  // namespace overbend::testing
