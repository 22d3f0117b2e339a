#include "system/free_body.h"

#include <algorithm>

#include "model/pipe/section.h"

namespace overbend {
namespace {

LineEndForces previous_line_forces(const HullState& state, std::size_t spring) {
  return spring < state.lines.size() ? state.lines[spring] : LineEndForces{};
}

}  // namespace

FreeBody free_hull(const Hull& hull, double line_weight, double length) {
  constexpr double kShareOfWeight = 1e-3;
  FreeBody body;
  body.reference_V = hull.reference_V;
  body.origin = hull.lies;
  body.force_scale = std::max(line_weight, kShareOfWeight * hull.body.mass * kGravity);
  body.arm = 0.5 * length;
  body.inertia << Vec3::Constant(hull.body.mass), hull.body.inertia.diagonal();
  body.inertia += hull.radiation.added_mass.diagonal();
  body.rest = make_static_hull(hull, hull.lies);
  body.balance = [&hull](const HullState& state, const HullState& before, const Weights& weights, double time,
                         HullBalance& out) {
    const bool rests = weights.acceleration == 0.0;  // statics, with memory of friction only
    balance_hull(hull, state, before, rests ? 0.0 : weights.step,
                 {1.0, rests ? 0.0 : weights.velocity, weights.acceleration}, time, out);
  };
  body.finish_step = [&hull](const HullState& before, double step, HullState& state) {
    finish_step(hull, before, step, state);
  };
  body.energy = [&hull](const HullState& state, double time, const HullBalance& step) {
    const HullEnergy energy = hull_energy(hull, state, time, step.surroundings);
    return BodyEnergy{energy.kinetic, energy.hydrostatic, energy.power()};
  };
  return body;
}

FreeBody free_point(const Vec3& place, double force_scale) {
  FreeBody body;
  body.force_scale = force_scale;
  body.inertia = Vec6::Zero();
  body.held = {false, false, false, true, true, true};
  body.rest.h.head<3>() = place;
  body.balance = [](const HullState&, const HullState&, const Weights&, double, HullBalance& out) { out = {}; };
  return body;
}

void add_springs(const FreeBody& body, const HullState& before, double time, HullState& state, HullBalance& out) {
  const BodyPose pose = make_pose(state.h);
  state.lines.resize(body.springs.size());
  for (std::size_t i = 0; i < body.springs.size(); ++i) {
    const BodySpring& spring = body.springs[i];
    const Vec3 arm = pose.R * (spring.place_V - body.reference_V);
    const PlaceForce spring_force = spring.force(pose.place + arm, time, previous_line_forces(before, i));
    state.lines[i] = spring_force.ends;
    const Mat36 moved = point_jacobian(pose, arm);
    out.residual -= moved.transpose() * spring_force.force;
    out.tangent +=
        moved.transpose() * spring_force.stiffness * moved - generalised_force_slope(pose, arm, spring_force.force);
  }
}

BodyEnergy spring_energy(const FreeBody& body, const HullState& state, double time) {
  const BodyPose pose = make_pose(state.h);
  BodyEnergy sum;
  for (std::size_t i = 0; i < body.springs.size(); ++i) {
    const BodySpring& spring = body.springs[i];
    const Vec3 arm = pose.R * (spring.place_V - body.reference_V);
    const PlaceForce spring_force = spring.force(pose.place + arm, time, previous_line_forces(state, i));
    if (spring.has_energy) {
      sum.stored += spring_force.energy;
    } else {
      sum.power += generalised_force(pose, arm, spring_force.force).dot(state.v);
    }
  }
  return sum;
}

RigidMotion rigid_motion(const FreeBody& body, const HullState& state) {
  return rigid_motion(make_body_motion(state.h, state.v, state.acc), body.reference_V, body.origin);
}

Mat36 point_rows(const BodyPose& pose, const Vec3& r) {
  return point_jacobian(pose, r - pose.place);
}

Mat36 vector_rows(const BodyPose& pose, const Vec3& t) {
  Mat36 rows = point_jacobian(pose, t);
  rows.leftCols<3>().setZero();
  return rows;
}

}  // namespace overbend
