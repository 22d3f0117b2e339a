#include "numerics/running_statistics_kernel.h"

#include "base/unaligned_lanes.h"

namespace overbend::OVERBEND_ISA_NAMESPACE {
namespace {

/// Adds one value, or one in every lane. `v` is used for the extremes, `value` for the mean.
template <class Value, class Sum>
inline void add_one(const Value& v, const Value& value, double weight, const Value& share, Sum& low, Sum& high,
                    Sum& mean, Sum& squares) {
  low = v < low ? v : low;
  high = v > high ? v : high;
  const Value from_old = value - mean;
  mean += share * from_old;
  squares += weight * from_old * (value - mean);
}

/// Adds a value that may be missing (NaN).
template <class Value, class Sum>
inline void add_if_present(const Value& v, double weight, Sum& weights, Sum& low, Sum& high, Sum& mean, Sum& squares) {
  const Value nothing{}, before = mean;
  const Value value = v == v ? v : before;
  weights += v == v ? nothing + weight : nothing;
  const Value share = weights > 0.0 ? weight / weights : nothing;
  add_one<Value>(v, value, weight, share, low, high, mean, squares);
}

}  // namespace

bool all_finite(const double* values, int count) {
  Lanes nothing{};
  int i = 0;
  for (; i + kWidth <= count; i += kWidth) nothing += 0.0 * unaligned(values + i);
  double sum = 0.0;
  for (int l = 0; l < kWidth; ++l) sum += nothing[l];
  for (; i < count; ++i) sum += 0.0 * values[i];
  return sum == 0.0;
}

void add_samples(const double* values, int count, const SampleWeight& by, const StatisticsView& to) {
  const double weight = by.weight;
  const Lanes share = Lanes{} + by.share;
  int i = 0;
  for (; i + kWidth <= count; i += kWidth) {
    const Lanes v = unaligned(values + i);
    add_one<Lanes>(v, v, weight, share, unaligned(to.low + i), unaligned(to.high + i), unaligned(to.mean + i),
                   unaligned(to.squares + i));
  }
  for (; i < count; ++i) {
    add_one<double>(values[i], values[i], weight, by.share, to.low[i], to.high[i], to.mean[i], to.squares[i]);
  }
}

void add_present_samples(const double* values, int count, double weight, double* weights, const StatisticsView& to) {
  int i = 0;
  for (; i + kWidth <= count; i += kWidth) {
    const Lanes v = unaligned(values + i);
    add_if_present<Lanes>(v, weight, unaligned(weights + i), unaligned(to.low + i), unaligned(to.high + i),
                          unaligned(to.mean + i), unaligned(to.squares + i));
  }
  for (; i < count; ++i) {
    add_if_present<double>(values[i], weight, weights[i], to.low[i], to.high[i], to.mean[i], to.squares[i]);
  }
}

}  // namespace overbend::OVERBEND_ISA_NAMESPACE
