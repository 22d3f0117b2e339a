/// Operations of the time integrator on all unknowns of a line alike. Compiled once per instruction set.
#pragma once

namespace overbend {

/// Writable values, rates and accelerations of `count` unknowns; the arrays do not overlap.
struct FreedomsView {
  int count;
  double *q, *v, *acc;
};

/// Motion at the start of a step, with the algorithmic acceleration of the generalized-alpha method.
struct FreedomsAtStart {
  const double *q, *v, *acc, *algorithmic_acceleration;
};

/// Coefficients of a prediction that is linear in both accelerations.
struct PredictionCoefficients {
  double step;  ///< [s]
  double q_by_acc, q_by_alg, v_by_acc, v_by_alg, acc_by_acc, acc_by_alg;
};

/// Change of rates and accelerations per correction of the values.
struct CorrectionCoefficients {
  double velocity, acceleration;
};

/// Coefficients of the algorithmic acceleration, a sum of three terms.
struct AccelerationCoefficients {
  double next_acc, acc, algorithmic_acceleration;
};

/// Change of the true acceleration over a step against the difference between the two accelerations before it: sums of
/// products and of squares.
struct ChangeSums {
  double product = 0.0, square = 0.0;
};

namespace isa_baseline {
void predict_freedoms(const PredictionCoefficients& shares, const FreedomsAtStart& start, const FreedomsView& next);
void correct_freedoms(const CorrectionCoefficients& shares, const double* dq, const FreedomsView& next);
ChangeSums end_freedoms(const AccelerationCoefficients& shares, const FreedomsAtStart& start, int count,
                        const double* acc, double* algorithmic_acceleration);
}  // namespace isa_baseline
namespace isa_avx2 {
void predict_freedoms(const PredictionCoefficients& shares, const FreedomsAtStart& start, const FreedomsView& next);
void correct_freedoms(const CorrectionCoefficients& shares, const double* dq, const FreedomsView& next);
ChangeSums end_freedoms(const AccelerationCoefficients& shares, const FreedomsAtStart& start, int count,
                        const double* acc, double* algorithmic_acceleration);
}  // namespace isa_avx2
namespace isa_avx512 {
void predict_freedoms(const PredictionCoefficients& shares, const FreedomsAtStart& start, const FreedomsView& next);
void correct_freedoms(const CorrectionCoefficients& shares, const double* dq, const FreedomsView& next);
ChangeSums end_freedoms(const AccelerationCoefficients& shares, const FreedomsAtStart& start, int count,
                        const double* acc, double* algorithmic_acceleration);
}  // namespace isa_avx512

}  // namespace overbend
