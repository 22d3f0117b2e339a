/// Transposition of registers of doubles. For kernels only, see simd.h: all code is in the unnamed namespace of one
/// instruction set.
#pragma once

#include <utility>

#include "base/simd.h"

namespace overbend::OVERBEND_ISA_NAMESPACE {
namespace {

/// One stage of a transposition: exchanges blocks of kStep lanes between rows kStep apart. L runs over the lanes.
template <int kStep, int... L>
inline void exchange(Lanes (&rows)[kWidth], std::integer_sequence<int, L...> /*all*/) {
  for (int i = 0; i < kWidth; ++i) {
    if ((i & kStep) == 0) {
      const Lanes a = rows[i], b = rows[i + kStep];
      rows[i] = __builtin_shufflevector(a, b, ((L & kStep) == 0 ? L : kWidth + L - kStep)...);
      rows[i + kStep] = __builtin_shufflevector(a, b, ((L & kStep) == 0 ? L + kStep : kWidth + L)...);
    }
  }
}

/// Transposes: lane l of row j becomes lane j of row l.
inline void transpose(Lanes (&rows)[kWidth]) {
  constexpr auto lanes = std::make_integer_sequence<int, kWidth>();
  exchange<1>(rows, lanes);
  if constexpr (kWidth > 2) {
    exchange<2>(rows, lanes);
  }
  if constexpr (kWidth > 4) {
    exchange<4>(rows, lanes);
  }
}

/// Sums of neighbouring blocks of kStep lanes, those of `a` in the lower half of each pair of blocks, those of `b` in
/// the upper half. L runs over the lanes.
template <int kStep, int... L>
inline Lanes added_blocks(const Lanes& a, const Lanes& b, std::integer_sequence<int, L...> /*all*/) {
  return __builtin_shufflevector(a, b, ((L & kStep) == 0 ? L : kWidth + L - kStep)...) +
         __builtin_shufflevector(a, b, ((L & kStep) == 0 ? L + kStep : kWidth + L)...);
}

/// Lane l receives the sum over the lanes of row l.
template <int kStep = 1>
inline Lanes row_sums(const Lanes (&rows)[kWidth / kStep]) {
  if constexpr (kStep == kWidth) {
    return rows[0];
  } else {
    Lanes halves[kWidth / (2 * kStep)];
    for (int i = 0; i < kWidth / (2 * kStep); ++i) {
      halves[i] = added_blocks<kStep>(rows[2 * i], rows[2 * i + 1], std::make_integer_sequence<int, kWidth>());
    }
    return row_sums<2 * kStep>(halves);
  }
}

}  // namespace
}  // namespace overbend::OVERBEND_ISA_NAMESPACE
