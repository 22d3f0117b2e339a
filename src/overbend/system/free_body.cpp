#include "system/free_body.h"

#include <algorithm>

#include "model/section.h"

namespace overbend {

FreeBody free_hull(const Hull& hull, double line_weight, double length) {
  constexpr double kShareOfWeight = 1e-3;
  FreeBody body;
  body.reference_V = hull.reference_V;
  body.drawn = hull.drawn;
  body.force_scale = std::max(line_weight, kShareOfWeight * hull.body.mass * kGravity);
  body.arm = 0.5 * length;
  body.inertia << Vec3::Constant(hull.body.mass), hull.body.inertia.diagonal();
  body.inertia += hull.radiation.added_mass.diagonal();
  body.rest = hull_at_rest(hull, hull.drawn);
  body.balance = [&hull](const HullState& at, const HullState& before, const Weights& weights, double time,
                         HullBalance& out) {
    const bool rests = weights.acceleration == 0.0;  // statics, in which friction alone remembers
    balance_hull(hull, at, before, rests ? 0.0 : weights.step,
                 {1.0, rests ? 0.0 : weights.velocity, weights.acceleration}, time, out);
  };
  body.finish_step = [&hull](const HullState& before, double step, HullState& at) {
    finish_step(hull, before, step, at);
  };
  body.energy = [&hull](const HullState& at, double time) {
    const HullEnergy energy = hull_energy(hull, at, time);
    return BodyEnergy{energy.kinetic, energy.hydrostatic, energy.power()};
  };
  return body;
}

void add_springs(const FreeBody& body, const HullState& at, HullBalance& out) {
  const BodyPose pose = pose_of(at.h);
  for (const BodySpring& spring : body.springs) {
    const Vec3 arm = pose.R * (spring.place_V - body.reference_V);
    const PlaceForce here = spring.force(pose.place + arm);
    const Mat36 moved = point_jacobian(pose, arm);
    out.residual -= moved.transpose() * here.force;
    out.tangent += moved.transpose() * here.stiffness * moved - generalised_force_slope(pose, arm, here.force);
  }
}

double spring_energy(const FreeBody& body, const HullState& at) {
  const BodyPose pose = pose_of(at.h);
  double energy = 0.0;
  for (const BodySpring& spring : body.springs) {
    energy += spring.force(pose.place + pose.R * (spring.place_V - body.reference_V)).energy;
  }
  return energy;
}

RigidMotion rigid_motion(const FreeBody& body, const HullState& at) {
  return rigid_motion(motion_of(at.h, at.v, at.acc), body.reference_V, body.drawn);
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
