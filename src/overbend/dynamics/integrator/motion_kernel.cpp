#include "dynamics/integrator/motion_kernel.h"

#include "base/unaligned_lanes.h"

namespace overbend::OVERBEND_ISA_NAMESPACE {

void predict_freedoms(const PredictionCoefficients& shares, const FreedomsAtStart& start, const FreedomsView& next) {
  const PredictionCoefficients by = shares;
  double* const __restrict q = next.q, * const __restrict v = next.v, * const __restrict acc = next.acc;
  for (int i = 0; i < next.count; ++i) {
    const double rate = start.v[i], true_acc = start.acc[i],
                 algorithmic_acceleration = start.algorithmic_acceleration[i];
    q[i] = start.q[i] + by.step * rate + by.q_by_acc * true_acc + by.q_by_alg * algorithmic_acceleration;
    v[i] = rate + by.v_by_acc * true_acc + by.v_by_alg * algorithmic_acceleration;
    acc[i] = by.acc_by_acc * true_acc + by.acc_by_alg * algorithmic_acceleration;
  }
}

void correct_freedoms(const CorrectionCoefficients& shares, const double* dq, const FreedomsView& next) {
  const CorrectionCoefficients by = shares;
  double* const __restrict q = next.q, * const __restrict v = next.v, * const __restrict acc = next.acc;
  for (int i = 0; i < next.count; ++i) {
    const double change = dq[i];
    q[i] += change;
    v[i] += by.velocity * change;
    acc[i] += by.acceleration * change;
  }
}

ChangeSums end_freedoms(const AccelerationCoefficients& shares, const FreedomsAtStart& start, int count,
                        const double* acc, double* algorithmic_acceleration) {
  const AccelerationCoefficients by = shares;
  Lanes product{}, square{};
  int i = 0;
  for (; i + kWidth <= count; i += kWidth) {
    const Lanes after = unaligned(acc + i), before = unaligned(start.acc + i),
                algorithmic = unaligned(start.algorithmic_acceleration + i);
    const Lanes apart = before - algorithmic;
    product += (after - before) * apart;
    square += apart * apart;
    unaligned(algorithmic_acceleration + i) =
        by.next_acc * after + by.acc * before + by.algorithmic_acceleration * algorithmic;
  }
  ChangeSums sums;
  for (int l = 0; l < kWidth; ++l) {
    sums.product += product[l];
    sums.square += square[l];
  }
  for (; i < count; ++i) {
    const double apart = start.acc[i] - start.algorithmic_acceleration[i];
    sums.product += (acc[i] - start.acc[i]) * apart;
    sums.square += apart * apart;
    algorithmic_acceleration[i] =
        by.next_acc * acc[i] + by.acc * start.acc[i] + by.algorithmic_acceleration * start.algorithmic_acceleration[i];
  }
  return sums;
}

}  // namespace overbend::OVERBEND_ISA_NAMESPACE
