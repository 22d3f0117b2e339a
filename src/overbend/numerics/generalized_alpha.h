/// Coefficients of the generalized-alpha method.
#pragma once

namespace overbend {

/// Chung & Hulbert (1993) in the form of Arnold & Bruels (2007): the equations of motion hold at t_{n+1} for the true
/// acceleration q'', and an algorithmic acceleration a runs beside it,
///     (1 - alpha_m) a_{n+1} + alpha_m a_n = (1 - alpha_f) q''_{n+1} + alpha_f q''_n
///     q_{n+1} = q_n + h v_n + h^2 ((1/2 - beta) a_n + beta a_{n+1})
///     v_{n+1} = v_n + h ((1 - gamma) a_n + gamma a_{n+1})
/// For linear systems this is Chung and Hulbert's scheme; for nonlinear ones every stored state is in balance, so that
/// forces with memory (contact, friction) are evaluated at real states alone. Second order.
struct GeneralizedAlpha {
  double alpha_m = 0.0, alpha_f = 0.0, beta = 0.25, gamma = 0.5;
  double half_foresight = 0.0;   ///< That foresees half of a steady change, and less where accelerations hardly differ.
  double whole_foresight = 0.0;  ///< That foresees the whole, and less only where they as good as agree.

  /// From the spectral radius at infinite frequency, 0 (all damped in one step) to 1 (nothing damped).
  explicit GeneralizedAlpha(double spectral_radius);

  /// True acceleration after one more step of the same length, to begin iterations with. The two accelerations stand
  /// apart by (alpha_f - alpha_m) h q''', which tells how the true one changes; `foresight` times that is taken: the
  /// whole takes vibrations that the step does not resolve for much larger ones.
  static double foreseen(double acc, double alg, double foresight) { return acc + foresight * (acc - alg); }

  /// Changes of velocity and true acceleration with the unknown, for a step h [1/s], [1/s2].
  double velocity_share(double h) const { return gamma / (h * beta); }
  double acceleration_share(double h) const { return (1.0 - alpha_m) / ((1.0 - alpha_f) * h * h * beta); }
};

/// One unknown's motion.
struct MotionValues {
  double q, v, acc, alg;  ///< Place, velocity, true and algorithmic acceleration.
};

/// The state after h when the true acceleration becomes `acc`.
inline MotionValues advance(const GeneralizedAlpha& g, const MotionValues& now, double h, double acc) {
  const double alg = ((1.0 - g.alpha_f) * acc + g.alpha_f * now.acc - g.alpha_m * now.alg) / (1.0 - g.alpha_m);
  return {now.q + h * now.v + h * h * ((0.5 - g.beta) * now.alg + g.beta * alg),
          now.v + h * ((1.0 - g.gamma) * now.alg + g.gamma * alg), acc, alg};
}

}  // namespace overbend
