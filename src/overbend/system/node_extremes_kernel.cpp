#include "system/node_extremes_kernel.h"

#include "base/loose_lanes.h"

namespace overbend::OVERBEND_ISA_NAMESPACE {
namespace {

constexpr int kNumbers = 6;    ///< Of a node.
constexpr int kRegisters = 3;  ///< After as many, lanes mean the same numbers of a node again, whatever their width.

inline Lanes larger(const Lanes& a, const Lanes& b) {
  return a > b ? a : b;
}

inline double larger(double a, double b) {
  return a > b ? a : b;
}

}  // namespace

double largest_triple(const double* values, const double* shares, int count) {
  Lanes most{}, sum{};
  int i = 0;
  for (; i + kWidth + 2 <= count; i += kWidth) {
    const Lanes x = loose(values + i), y = loose(values + i + 1), z = loose(values + i + 2);
    const Lanes of_triple = loose(shares + i) * (x * x + y * y + z * z);
    most = larger(of_triple, most);
    sum += of_triple;
  }
  double largest = 0.0, total = 0.0;
  for (int l = 0; l < kWidth; ++l) {
    largest = larger(most[l], largest);
    total += sum[l];
  }
  for (i -= i % 3; i < count; i += 3) {
    const double x = values[i], y = values[i + 1], z = values[i + 2];
    const double of_triple = shares[i] * (x * x + y * y + z * z);
    largest = larger(of_triple, largest);
    total += of_triple;
  }
  // A maximum passes over NaN, a sum does not; and infinity less itself is none.
  return total - total == 0.0 ? largest : __builtin_inf();
}

LargestChanges largest_changes(const double* now, const double* then, int count) {
  constexpr int kStride = kRegisters * kWidth;
  Lanes most[kRegisters] = {};
  int i = 0;
  for (; i + kStride <= count; i += kStride) {
    for (int part = 0; part < kRegisters; ++part) {
      const Lanes change = loose(now + i + part * kWidth) - loose(then + i + part * kWidth);
      most[part] = larger(change * change, most[part]);
    }
  }
  LargestChanges largest{};
  for (int k = 0; k < kStride; ++k) {
    double& of = largest.squares[k % kNumbers];
    of = larger(most[k / kWidth][k % kWidth], of);
  }
  for (; i < count; ++i) {
    const double change = now[i] - then[i];
    double& of = largest.squares[i % kNumbers];
    of = larger(change * change, of);
  }
  return largest;
}

}  // namespace overbend::OVERBEND_ISA_NAMESPACE
