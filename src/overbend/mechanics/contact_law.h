/// The law of contact between pipe and roller: forces from penetration, rates and what the contact remembers.
///
///     normal      k g + c g'            for g > 0, never pulling         [silva2009] equations 11 to 14
///     tangential  k_T s + c_T v, at most mu times the normal force       [silva2009] equation 15
///
/// s is the slip since the contact began; past the Coulomb limit the roller slides and s stops growing (return
/// mapping). Along the pipe mu is the roller's rolling resistance, across it the friction of pipe on roller.
#pragma once

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

/// `penetration` g [m], positive in contact; `rate` = dg/dt [m/s].
inline NormalForce normal_force(const ContactLaw& law, double penetration, double rate) {
  if (penetration <= 0.0) {
    return {};
  }
  const double force = law.stiffness * penetration + law.damping * rate;
  return force > 0.0 ? NormalForce{force, law.stiffness, law.damping} : NormalForce{};
}

/// Friction in one direction, with its derivatives and the new slip.
struct FrictionForce {
  double force = 0.0;      ///< On the pipe, in the direction the slip is measured [N].
  double by_rate = 0.0;    ///< [N s/m]
  double by_normal = 0.0;  ///< [-]
  double slip = 0.0;       ///< Elastic part at the end of the step [m].
};

/// `slip` at the start of a step of `dt` [s], `rate` of slip at its end [m/s], `normal` force at its end [N].
inline FrictionForce friction_force(const ContactLaw& law, double mu, double slip, double rate, double dt,
                                    double normal) {
  const double trial_slip = slip + dt * rate;
  const double trial = law.tangential_stiffness * trial_slip + law.tangential_damping * rate;
  const double limit = mu * normal;
  if (trial > limit || trial < -limit) {
    const double side = trial > 0.0 ? 1.0 : -1.0;
    const double kept = law.tangential_stiffness > 0.0 ? side * limit / law.tangential_stiffness : 0.0;
    return {-side * limit, 0.0, -side * mu, kept};
  }
  return {-trial, -(law.tangential_stiffness * dt + law.tangential_damping), 0.0, trial_slip};
}

}  // namespace overbend
