/// What the integrator does with all freedoms of a line, one like the other. Compiled once per instruction set.
#pragma once

namespace overbend {

/// Values, rates and accelerations of `count` freedoms that may be written to; none overlaps another.
struct FreedomsView {
  int count;
  double *q, *v, *acc;
};

/// A step's beginning: as above, with the algorithmic acceleration of the generalized-alpha method.
struct FreedomsBefore {
  const double *q, *v, *acc, *alg;
};

/// A prediction that is linear in both accelerations: by how much each of them counts.
struct PredictionShares {
  double step;  ///< [s]
  double q_by_acc, q_by_alg, v_by_acc, v_by_alg, acc_by_acc, acc_by_alg;
};

/// What a correction of the values makes of rates and accelerations.
struct CorrectionShares {
  double velocity, acceleration;
};

/// The algorithmic acceleration as a sum of three.
struct EndShares {
  double next_acc, acc, alg;
};

/// How the true acceleration changed over a step, over what stood between the two accelerations before it: the sums of
/// the products and of the squares.
struct ChangeSums {
  double product = 0.0, square = 0.0;
};

namespace isa_baseline {
void predict_freedoms(const PredictionShares& shares, const FreedomsBefore& now, const FreedomsView& next);
void correct_freedoms(const CorrectionShares& shares, const double* dq, const FreedomsView& next);
ChangeSums end_freedoms(const EndShares& shares, const FreedomsBefore& now, int count, const double* acc, double* alg);
}  // namespace isa_baseline
namespace isa_avx2 {
void predict_freedoms(const PredictionShares& shares, const FreedomsBefore& now, const FreedomsView& next);
void correct_freedoms(const CorrectionShares& shares, const double* dq, const FreedomsView& next);
ChangeSums end_freedoms(const EndShares& shares, const FreedomsBefore& now, int count, const double* acc, double* alg);
}  // namespace isa_avx2
namespace isa_avx512 {
void predict_freedoms(const PredictionShares& shares, const FreedomsBefore& now, const FreedomsView& next);
void correct_freedoms(const CorrectionShares& shares, const double* dq, const FreedomsView& next);
ChangeSums end_freedoms(const EndShares& shares, const FreedomsBefore& now, int count, const double* acc, double* alg);
}  // namespace isa_avx512

}  // namespace overbend
