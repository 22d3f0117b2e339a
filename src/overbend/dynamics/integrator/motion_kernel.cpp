#include "dynamics/integrator/motion_kernel.h"

#include "base/loose_lanes.h"

namespace overbend::OVERBEND_ISA_NAMESPACE {

void predict_freedoms(const PredictionShares& shares, const FreedomsBefore& now, const FreedomsView& next) {
  const PredictionShares by = shares;
  double* const __restrict q = next.q, * const __restrict v = next.v, * const __restrict acc = next.acc;
  for (int i = 0; i < next.count; ++i) {
    const double rate = now.v[i], true_acc = now.acc[i], alg = now.alg[i];
    q[i] = now.q[i] + by.step * rate + by.q_by_acc * true_acc + by.q_by_alg * alg;
    v[i] = rate + by.v_by_acc * true_acc + by.v_by_alg * alg;
    acc[i] = by.acc_by_acc * true_acc + by.acc_by_alg * alg;
  }
}

void correct_freedoms(const CorrectionShares& shares, const double* dq, const FreedomsView& next) {
  const CorrectionShares by = shares;
  double* const __restrict q = next.q, * const __restrict v = next.v, * const __restrict acc = next.acc;
  for (int i = 0; i < next.count; ++i) {
    const double change = dq[i];
    q[i] += change;
    v[i] += by.velocity * change;
    acc[i] += by.acceleration * change;
  }
}

ChangeSums end_freedoms(const EndShares& shares, const FreedomsBefore& now, int count, const double* acc, double* alg) {
  const EndShares by = shares;
  Lanes product{}, square{};
  int i = 0;
  for (; i + kWidth <= count; i += kWidth) {
    const Lanes after = loose(acc + i), before = loose(now.acc + i), algorithmic = loose(now.alg + i);
    const Lanes apart = before - algorithmic;
    product += (after - before) * apart;
    square += apart * apart;
    loose(alg + i) = by.next_acc * after + by.acc * before + by.alg * algorithmic;
  }
  ChangeSums sums;
  for (int l = 0; l < kWidth; ++l) {
    sums.product += product[l];
    sums.square += square[l];
  }
  for (; i < count; ++i) {
    const double apart = now.acc[i] - now.alg[i];
    sums.product += (acc[i] - now.acc[i]) * apart;
    sums.square += apart * apart;
    alg[i] = by.next_acc * acc[i] + by.acc * now.acc[i] + by.alg * now.alg[i];
  }
  return sums;
}

}  // namespace overbend::OVERBEND_ISA_NAMESPACE
