#include "mechanics/hinge_law.h"

namespace overbend {
namespace {

/// `side` 1: the lower stop, approached by a growing angle; -1: the upper one.
void add_stop(const HingeLaw& law, double beyond, double rate, double side, HingeMoment& sum) {
  ContactLaw stop;
  stop.stiffness = law.stop_stiffness;
  stop.damping = law.stop_damping;
  const NormalForce push = normal_force(stop, beyond, side * rate);
  sum.stop -= side * push.force;
  sum.by_angle -= push.by_penetration;
  sum.by_rate -= push.by_rate;
  sum.stored += beyond > 0.0 ? 0.5 * law.stop_stiffness * beyond * beyond : 0.0;
}

}  // namespace

double stop_spring_moment(const HingeLaw& law, double angle) {
  if (angle > law.down) {
    return -law.stop_stiffness * (angle - law.down);
  }
  return angle < law.up ? law.stop_stiffness * (law.up - angle) : 0.0;
}

HingeMoment hinge_moment(const HingeLaw& law, double angle, double rate, double slip, double dt) {
  HingeMoment sum;
  add_stop(law, angle - law.down, rate, 1.0, sum);
  add_stop(law, law.up - angle, rate, -1.0, sum);
  if (law.friction > 0.0) {
    ContactLaw rub;
    rub.tangential_stiffness = law.friction / kBreakawayRotation;
    rub.tangential_damping = law.friction_damping;
    const FrictionForce friction = friction_force(rub, 1.0, {slip, rate, dt, law.friction});
    sum.friction = friction.force;
    sum.by_rate += friction.by_rate;
    sum.slip = friction.slip;
  }
  return sum;
}

}  // namespace overbend
