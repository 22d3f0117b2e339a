/// Law of contact between pipe and roller: forces from penetration, rates and contact history.
///
///     normal      k g + c g'            for g > 0, never pulling         [silva2009] equations 11 to 14
///     tangential  k_T s + c_T v, at most mu times the normal force       [silva2009] equation 15
///
/// s is the slip since the contact began; past the Coulomb limit the roller slides and s stops growing (return
/// mapping). Along the pipe mu is the roller's rolling resistance, across it the friction of pipe on roller.
#pragma once

#include <algorithm>
#include <optional>

namespace overbend {

/// Constants of one roller.
struct ContactLaw {
  double stiffness = 0.0;             ///< k [N/m]
  double damping = 0.0;               ///< c [N s/m]
  double tangential_stiffness = 0.0;  ///< k_T [N/m]
  double tangential_damping = 0.0;    ///< c_T [N s/m]
  double friction_axial = 0.0;        ///< mu along the pipe [-]
  double friction_lateral = 0.0;      ///< mu across the pipe [-]
};

/// Normal force with its derivatives.
struct NormalForce {
  double force = 0.0;           ///< On the pipe, away from the roller [N].
  double by_penetration = 0.0;  ///< [N/m]
  double by_rate = 0.0;         ///< [N s/m]
};

/// Spring and dashpot without cut-off, tensile if negative: for contacts of the active set.
inline NormalForce attached_force(const ContactLaw& law, double penetration, double rate) {
  return {law.stiffness * penetration + law.damping * rate, law.stiffness, law.damping};
}

/// Returns the normal force; zero without contact and where spring and dashpot would pull. `penetration` g [m],
/// positive in contact; `rate` = dg/dt [m/s].
inline NormalForce normal_force(const ContactLaw& law, double penetration, double rate) {
  if (penetration <= 0.0) {
    return {};
  }
  const NormalForce attached = attached_force(law, penetration, rate);
  return attached.force > 0.0 ? attached : NormalForce{};
}

enum class Slip { backward = -1, stick = 0, forward = 1 };

/// Friction in one direction, with its derivatives and the new slip.
struct FrictionForce {
  double force = 0.0;      ///< Acts on the pipe, in the direction the slip is measured [N].
  double by_rate = 0.0;    ///< [N s/m]
  double by_normal = 0.0;  ///< [-]
  double slip = 0.0;       ///< Elastic part at the end of the step [m].
  Slip state = Slip::stick;
};

/// Kinematics of a friction step of `dt` [s]: elastic `slip` at its start [m], sliding `rate` at its end [m/s],
/// `normal` force at its end [N]; `start_rate` [m/s] if the contact existed before the step.
struct SlipStep {
  double slip = 0.0, rate = 0.0, dt = 0.0, normal = 0.0;
  std::optional<double> start_rate{};
};

/// Elastic slip at the end of a step in which the contact sticks from some instant on.
struct ElasticSlip {
  double slip = 0.0, by_rate = 0.0;  ///< [m], [s]
  double by_max_slip = 0.0;          ///< Derivative with the slip limit [-].
};

/// Returns the elastic slip for a rate that is linear in the step. Where the rate changes sign, the slip at that
/// instant is limited to `max_slip` in either direction, and returns from there.
inline ElasticSlip elastic_slip(const SlipStep& step, double max_slip) {
  const double r1 = step.rate, r0 = step.start_rate.value_or(r1), dt = step.dt;
  if (!(r0 * r1 < 0.0)) {
    return {step.slip + 0.5 * dt * (r0 + r1), step.start_rate ? 0.5 * dt : dt, 0.0};
  }
  const double turn = r0 / (r0 - r1), back = 1.0 - turn;  // fractions of the step
  const double free = step.slip + 0.5 * dt * r0 * turn, farthest = std::clamp(free, -max_slip, max_slip);
  const double sign = farthest < free ? 1.0 : farthest > free ? -1.0 : 0.0;
  const double outwards = sign == 0.0 ? 0.5 * dt * turn * turn : 0.0;
  return {farthest + 0.5 * dt * r1 * back, outwards + 0.5 * dt * back * (1.0 + turn), sign};
}

/// Returns the friction of a contact known to stick or to slide; `mu` [-].
inline FrictionForce friction_in_state(const ContactLaw& law, double mu, const SlipStep& step, Slip state) {
  if (state == Slip::stick) {
    const double k = law.tangential_stiffness;
    const ElasticSlip elastic = elastic_slip(step, k > 0.0 ? std::max(mu * step.normal, 0.0) / k : 0.0);
    return {-(k * elastic.slip + law.tangential_damping * step.rate), -(k * elastic.by_rate + law.tangential_damping),
            -mu * elastic.by_max_slip, elastic.slip, state};
  }
  const double side = static_cast<int>(state);
  const double limit = mu * step.normal;
  return {-side * limit, 0.0, -side * mu,
          law.tangential_stiffness > 0.0 ? side * limit / law.tangential_stiffness : 0.0, state};
}

/// Returns the friction by return mapping: stick within the Coulomb limit, else slip. `mu` is the friction coefficient
/// [-].
inline FrictionForce friction_force(const ContactLaw& law, double mu, const SlipStep& step) {
  const FrictionForce stick = friction_in_state(law, mu, step, Slip::stick);
  const double limit = mu * step.normal;
  if (stick.force <= limit && stick.force >= -limit) {
    return stick;
  }
  return friction_in_state(law, mu, step, stick.force < 0.0 ? Slip::forward : Slip::backward);
}

}  // namespace overbend
