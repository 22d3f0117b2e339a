/// Coefficients of the generalized-alpha method.
#pragma once

namespace overbend {

/// Chung & Hulbert (1993) in the form of Arnold & Bruels (2007): the equations of motion hold at t_{n+1} for the true
/// acceleration q'', and a separate algorithmic acceleration a is integrated,
///     (1 - alpha_m) a_{n+1} + alpha_m a_n = (1 - alpha_f) q''_{n+1} + alpha_f q''_n
///     q_{n+1} = q_n + h v_n + h^2 ((1/2 - beta) a_n + beta a_{n+1})
///     v_{n+1} = v_n + h ((1 - gamma) a_n + gamma a_{n+1})
/// For linear systems this is Chung and Hulbert's scheme; for nonlinear ones every stored state is in equilibrium, so
/// that forces with memory (contact, friction) are evaluated at real states only. Second order.
struct GeneralizedAlpha {
  double alpha_m = 0.0, alpha_f = 0.0, beta = 0.25, gamma = 0.5;
  /// Extrapolation factor that predicts half of a constant rate of change; less where accelerations hardly differ.
  double half_extrapolation = 0.0;
  /// Extrapolation factor that predicts all of it; less only where accelerations nearly agree.
  double full_extrapolation = 0.0;

  /// Coefficients for the spectral radius at infinite frequency, 0 (annihilated in one step) to 1 (undamped).
  explicit GeneralizedAlpha(double spectral_radius);

  /// Returns the predicted true acceleration after one more step of equal length, as start value of the iteration. The
  /// two accelerations differ by (alpha_f - alpha_m) h q''', the rate of change of the true one; `extrapolation` times
  /// that is added: the full factor strongly overestimates vibrations that the step does not resolve.
  static double extrapolated(double acc, double algorithmic_acceleration, double extrapolation) {
    return acc + extrapolation * (acc - algorithmic_acceleration);
  }

  /// Derivatives of velocity and true acceleration with the unknown, for a step h [1/s], [1/s2].
  double velocity_share(double h) const { return gamma / (h * beta); }
  double acceleration_share(double h) const { return (1.0 - alpha_m) / ((1.0 - alpha_f) * h * h * beta); }
};

/// One unknown's motion.
struct MotionValues {
  double q, v, acc, algorithmic_acceleration;  ///< Position, velocity, true and algorithmic acceleration.
};

/// Returns the state after a step `h` [s] with the true acceleration `acc` at its end.
inline MotionValues advance(const GeneralizedAlpha& g, const MotionValues& motion, double h, double acc) {
  const double algorithmic_acceleration =
      ((1.0 - g.alpha_f) * acc + g.alpha_f * motion.acc - g.alpha_m * motion.algorithmic_acceleration) /
      (1.0 - g.alpha_m);
  return {motion.q + h * motion.v +
              h * h * ((0.5 - g.beta) * motion.algorithmic_acceleration + g.beta * algorithmic_acceleration),
          motion.v + h * ((1.0 - g.gamma) * motion.algorithmic_acceleration + g.gamma * algorithmic_acceleration), acc,
          algorithmic_acceleration};
}

}  // namespace overbend
