/// Rows of a node's block in registers, and their elimination. For the kernels alone: everything here is compiled once
/// per instruction set.
#pragma once

#include "numerics/block_tridiagonal_kernel.h"

#if defined(__SSE2__)
#include <immintrin.h>
#endif

#include <utility>

#include "base/simd.h"

namespace overbend::OVERBEND_ISA_NAMESPACE {
namespace {

inline double magnitude(double x) {
  return __builtin_fabs(x);
}

static_assert(kRowWidth == kLanes, "a row of a block is one batch of lanes");
inline constexpr int kParts = kLanes / kWidth;

/// A row of eight in as many registers as it takes.
struct Row {
  Lanes part[kParts];

  double& operator[](int i) { return reinterpret_cast<double*>(part)[i]; }
  double operator[](int i) const { return reinterpret_cast<const double*>(part)[i]; }
  void scale(double factor) {
    for (Lanes& p : part) {
      p *= factor;
    }
  }
  void subtract(double factor, const Row& row) {
    for (int i = 0; i < kParts; ++i) {
      part[i] -= factor * row.part[i];
    }
  }
};

/// A pivot this small against the block's largest entry means that rounding is all that is left of it.
inline constexpr double kPivotFloor = 1e-14;

/// Rows are exchanged where a pivot is smaller than this fraction of the entries below it, or of its initial value.
inline constexpr double kPivotShare = 0.02;
inline constexpr double kPivotLoss = 1e-10;

/// Whether the registers hold a block and what couples it to the node that is next at the same time.
inline constexpr bool kBothInRegisters = kParts == 1;

/// A block with its right-hand sides and, if there is room, what couples it to the node that is next.
struct BlockRows {
  Row d[kNodeDofs], u[kNodeDofs];
  /// By pivot and row: what was taken of the pivot row; of the pivot row itself, what it was scaled by.
  double factor[kNodeDofs][kNodeDofs];
  bool negative = false;  ///< The determinant so far.
  bool good = true;
};

/// v with lane K of another. The compiler's own way would send it through memory.
template <int K>
inline Lanes exchanged_lane(const Lanes& v, const Lanes& by) {
#if defined(__AVX512F__)
  return _mm512_mask_blend_pd(1 << K, v, by);
#elif defined(__AVX__)
  return _mm256_blend_pd(v, by, 1 << K);
#elif defined(__SSE2__)
  return K == 0 ? _mm_move_sd(v, by) : _mm_move_sd(by, v);
#else
  Lanes exchanged = v;
  exchanged[K] = by[K];
  return exchanged;
#endif
}

template <int K, int... L>
inline Lanes repeated_lane(const Lanes& v, std::integer_sequence<int, L...> /*all*/) {
  return __builtin_shufflevector(v, v, (L * 0 + K)...);
}

/// Lane K everywhere.
template <int K>
inline Lanes repeated_lane(const Lanes& v) {
  return repeated_lane<K>(v, std::make_integer_sequence<int, kWidth>());
}

/// Takes out row I by the pivot row K, already scaled; `largest` keeps the largest entry below the pivot.
template <bool kCoupled, int K, int I>
inline __attribute__((always_inline)) void take_out(BlockRows& rows, double& largest) {
  if constexpr (I != K) {
    constexpr int kPart = K / kWidth, kLane = K % kWidth;
    Row& row = rows.d[I];
    const Lanes factor = repeated_lane<kLane>(row.part[kPart]);
    if constexpr (I > K) {
      largest = magnitude(factor[0]) > largest ? magnitude(factor[0]) : largest;
    }
    if constexpr (!kBothInRegisters) rows.factor[K][I] = factor[0];
    row.part[kPart] = exchanged_lane<kLane>(row.part[kPart], Lanes{});
    for (int i = 0; i < kParts; ++i) {
      row.part[i] -= factor * rows.d[K].part[i];
      if constexpr (kCoupled) rows.u[I].part[i] -= factor * rows.u[K].part[i];
    }
  }
}

template <bool kCoupled, int K, int... I>
inline __attribute__((always_inline)) void eliminate_row(BlockRows& rows, const double* at_first,
                                                         std::integer_sequence<int, I...> /*all*/) {
  constexpr int kPart = K / kWidth, kLane = K % kWidth;
  Row& row = rows.d[K];
  const double pivot = row.part[kPart][kLane];
  row.part[kPart] = exchanged_lane<kLane>(row.part[kPart], Lanes{} + 1.0);
  const double inverse = 1.0 / pivot;
  row.scale(inverse);
  if constexpr (!kBothInRegisters) rows.factor[K][K] = inverse;
  if constexpr (kCoupled) rows.u[K].scale(inverse);
  double largest = 0.0;
  (take_out<kCoupled, K, I>(rows, largest), ...);
  const bool keeps =
      (magnitude(pivot) > kPivotLoss * magnitude(at_first[K])) & (kPivotShare * largest <= magnitude(pivot));
  rows.good = rows.good & keeps;
  rows.negative = rows.negative != (pivot < 0.0);
}

template <bool kCoupled, int... K>
inline __attribute__((always_inline)) void eliminate_rows(BlockRows& rows, const double* at_first,
                                                          std::integer_sequence<int, K...> all) {
  (eliminate_row<kCoupled, K>(rows, at_first, all), ...);
}

/// Two registers of every row of u go through an elimination that was made before, step by step.
inline __attribute__((always_inline)) void repeat(const double (&factor)[kNodeDofs][kNodeDofs], Row* u, int first) {
  constexpr int kTogether = 2;
  static_assert(kBothInRegisters || kParts % kTogether == 0);
  Lanes part[kNodeDofs][kTogether];
#pragma GCC unroll 6
  for (int i = 0; i < kNodeDofs; ++i) {
    for (int p = 0; p < kTogether; ++p) part[i][p] = u[i].part[first + p];
  }
#pragma GCC unroll 6
  for (int k = 0; k < kNodeDofs; ++k) {
    for (int p = 0; p < kTogether; ++p) part[k][p] *= factor[k][k];
#pragma GCC unroll 6
    for (int i = 0; i < kNodeDofs; ++i) {
      for (int p = 0; p < (i == k ? 0 : kTogether); ++p) part[i][p] -= factor[k][i] * part[k][p];
    }
  }
#pragma GCC unroll 6
  for (int i = 0; i < kNodeDofs; ++i) {
    for (int p = 0; p < kTogether; ++p) u[i].part[first + p] = part[i][p];
  }
}

/// What `eliminate` does, without exchanging rows: most blocks need none, and then nothing has to wait for memory.
/// Returns 0 and leaves everything as it was where some row should be exchanged.
template <bool kCoupled>
inline int eliminate_in_place(Row* d, Row* u) {
  constexpr bool kTogether = kCoupled && kBothInRegisters;
  BlockRows rows;
  double at_first[kNodeDofs];
  for (int i = 0; i < kNodeDofs; ++i) {
    rows.d[i] = d[i];
    if constexpr (kTogether) rows.u[i] = u[i];
    at_first[i] = d[i][i];
  }
  eliminate_rows<kTogether>(rows, at_first, std::make_integer_sequence<int, kNodeDofs>());
  if (!rows.good) {
    return 0;
  }
  for (int i = 0; i < kNodeDofs; ++i) {
    d[i] = rows.d[i];
    if constexpr (kTogether) u[i] = rows.u[i];
  }
  if constexpr (kCoupled && !kBothInRegisters) {
    for (int first = 0; first < kParts; first += 2) repeat(rows.factor, u, first);
  }
  return rows.negative ? -1 : 1;
}

/// Gauss-Jordan on [D | b c] and U together: b, c and U become D^-1 b, D^-1 c, D^-1 U, and D its inverse, which serves
/// further right-hand sides. U is not multiplied by the inverse: where a line hardly stretches that would lose the
/// digits which its bending has. Returns the sign of the determinant, 0 when singular.
template <bool kCoupled>
__attribute__((noinline)) int eliminate(Row* d, Row* u) {
  double largest = 0.0;
  for (int i = 0; i < kNodeDofs; ++i) {
    for (int j = 0; j < kNodeDofs; ++j) {
      largest = magnitude(d[i][j]) > largest ? magnitude(d[i][j]) : largest;
    }
  }
  int sign = 1;
  int swapped_with[kNodeDofs];
  for (int k = 0; k < kNodeDofs; ++k) {
    int pivot = k;
    for (int i = k + 1; i < kNodeDofs; ++i) {
      pivot = magnitude(d[i][k]) > magnitude(d[pivot][k]) ? i : pivot;
    }
    if (!(magnitude(d[pivot][k]) > kPivotFloor * largest)) {
      return 0;
    }
    swapped_with[k] = pivot;
    if (pivot != k) {
      std::swap(d[k], d[pivot]);
      if constexpr (kCoupled) std::swap(u[k], u[pivot]);
      sign = -sign;
    }
    sign = d[k][k] < 0.0 ? -sign : sign;
    const double inverse = 1.0 / d[k][k];
    d[k][k] = 1.0;
    d[k].scale(inverse);
    if constexpr (kCoupled) u[k].scale(inverse);
    for (int i = 0; i < kNodeDofs; ++i) {
      if (i != k) {
        const double factor = d[i][k];
        d[i][k] = 0.0;
        d[i].subtract(factor, d[k]);
        if constexpr (kCoupled) u[i].subtract(factor, u[k]);
      }
    }
  }
  for (int k = kNodeDofs - 1; k >= 0; --k) {  // exchanged rows of D are exchanged columns of its inverse
    if (swapped_with[k] != k) {
      for (int i = 0; i < kNodeDofs; ++i) {
        const double kept = d[i][k];
        d[i][k] = d[i][swapped_with[k]];
        d[i][swapped_with[k]] = kept;
      }
    }
  }
  return sign;
}

/// The inverse of a node's block D, its coupling U with the node that is next becomes X = D^-1 U; the sign of the
/// determinant, 0 when singular.
template <bool kCoupled>
inline int invert(Row* d, Row* u) {
  const int sign = eliminate_in_place<kCoupled>(d, u);
  return sign != 0 ? sign : eliminate<kCoupled>(d, u);
}

/// The columns that the next node is coupled by, with the right-hand sides beside them.
inline Row with_sides(const Row& u, const Row& d) {
  Row row = u;
#if OVERBEND_ISA_WIDTH == 8
  row.part[0] = __builtin_shufflevector(u.part[0], d.part[0], 0, 1, 2, 3, 4, 5, 14, 15);
#elif OVERBEND_ISA_WIDTH == 4
  row.part[1] = __builtin_shufflevector(u.part[1], d.part[1], 0, 1, 6, 7);
#else
  row.part[3] = d.part[3];
#endif
  return row;
}

/// [D | b c] of the node that is next loses `back` times [X | x y] of this one: `x` has both, see with_sides().
inline __attribute__((always_inline)) void update(Row* d_next, const double* back, const Row (&x)[kNodeDofs]) {
  for (int i = 0; i < kNodeDofs; ++i) {
    Row row = d_next[i];
    for (int k = 0; k < kNodeDofs; ++k) {
      row.subtract(back[i * kLanes + k], x[k]);
    }
    d_next[i] = row;
  }
}

/// Updates the node that is next by what it is coupled with by `back`.
inline __attribute__((always_inline)) void pass_on(const Row* d, const Row* u, const double* back, Row* d_next) {
  Row x[kNodeDofs];
  for (int i = 0; i < kNodeDofs; ++i) {
    x[i] = with_sides(u[i], d[i]);
  }
  update(d_next, back, x);
}

}  // namespace
}  // namespace overbend::OVERBEND_ISA_NAMESPACE
