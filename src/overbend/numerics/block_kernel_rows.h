/// Rows of a node's block in registers, and their elimination. For kernels only: all code is compiled once per
/// instruction set.
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

/// Row of eight values in the registers it needs.
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

/// Relative pivot threshold: a pivot this small against the block's max_entry entry is rounding noise.
inline constexpr double kPivotFloor = 1e-14;

/// Rows are exchanged if a pivot is smaller than this fraction of the entries below it, or of its initial value.
inline constexpr double kPivotShare = 0.02;
inline constexpr double kPivotLoss = 1e-10;

/// True if the registers hold a block and its coupling to the next node at the same time.
inline constexpr bool kBothInRegisters = kParts == 1;

/// A block with its right-hand sides and, if there is room, its coupling to the next node.
struct BlockRows {
  Row d[kNodeDofs], u[kNodeDofs];
  /// By pivot and row: factor of the pivot row subtracted from the row; for the pivot row itself, its scale factor.
  double factor[kNodeDofs][kNodeDofs];
  bool negative = false;  ///< Sign of the determinant so far.
  bool good = true;
};

/// Returns v with lane K of another vector. The compiler's code for it would pass through memory.
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

/// Broadcasts lane K.
template <int K>
inline Lanes repeated_lane(const Lanes& v) {
  return repeated_lane<K>(v, std::make_integer_sequence<int, kWidth>());
}

/// Eliminates row I with pivot row K, already scaled; `max_entry` receives the max_entry entry below the pivot.
template <bool kCoupled, int K, int I>
inline __attribute__((always_inline)) void eliminate_entry(BlockRows& rows, double& max_entry) {
  if constexpr (I != K) {
    constexpr int kPart = K / kWidth, kLane = K % kWidth;
    Row& row = rows.d[I];
    const Lanes factor = repeated_lane<kLane>(row.part[kPart]);
    if constexpr (I > K) {
      max_entry = magnitude(factor[0]) > max_entry ? magnitude(factor[0]) : max_entry;
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
  double max_entry = 0.0;
  (eliminate_entry<kCoupled, K, I>(rows, max_entry), ...);
  const bool keeps =
      (magnitude(pivot) > kPivotLoss * magnitude(at_first[K])) & (kPivotShare * max_entry <= magnitude(pivot));
  rows.good = rows.good & keeps;
  rows.negative = rows.negative != (pivot < 0.0);
}

template <bool kCoupled, int... K>
inline __attribute__((always_inline)) void eliminate_rows(BlockRows& rows, const double* at_first,
                                                          std::integer_sequence<int, K...> all) {
  (eliminate_row<kCoupled, K>(rows, at_first, all), ...);
}

/// Applies a stored elimination, step by step, to two registers of every row of u.
inline __attribute__((always_inline)) void repeat(const double (&factor)[kNodeDofs][kNodeDofs], Row* u, int first) {
  constexpr int kCoupledIterations = 2;
  static_assert(kBothInRegisters || kParts % kCoupledIterations == 0);
  Lanes part[kNodeDofs][kCoupledIterations];
#pragma GCC unroll 6
  for (int i = 0; i < kNodeDofs; ++i) {
    for (int p = 0; p < kCoupledIterations; ++p) part[i][p] = u[i].part[first + p];
  }
#pragma GCC unroll 6
  for (int k = 0; k < kNodeDofs; ++k) {
    for (int p = 0; p < kCoupledIterations; ++p) part[k][p] *= factor[k][k];
#pragma GCC unroll 6
    for (int i = 0; i < kNodeDofs; ++i) {
      for (int p = 0; p < (i == k ? 0 : kCoupledIterations); ++p) part[i][p] -= factor[k][i] * part[k][p];
    }
  }
#pragma GCC unroll 6
  for (int i = 0; i < kNodeDofs; ++i) {
    for (int p = 0; p < kCoupledIterations; ++p) u[i].part[first + p] = part[i][p];
  }
}

/// Elimination as in `eliminate`, without row exchanges: most blocks need none, and avoid memory access. Returns 0 and
/// leaves everything unchanged if a row should be exchanged.
template <bool kCoupled>
inline int eliminate_in_place(Row* d, Row* u) {
  constexpr bool kCoupledIterations = kCoupled && kBothInRegisters;
  BlockRows rows;
  double at_first[kNodeDofs];
  for (int i = 0; i < kNodeDofs; ++i) {
    rows.d[i] = d[i];
    if constexpr (kCoupledIterations) rows.u[i] = u[i];
    at_first[i] = d[i][i];
  }
  eliminate_rows<kCoupledIterations>(rows, at_first, std::make_integer_sequence<int, kNodeDofs>());
  if (!rows.good) {
    return 0;
  }
  for (int i = 0; i < kNodeDofs; ++i) {
    d[i] = rows.d[i];
    if constexpr (kCoupledIterations) u[i] = rows.u[i];
  }
  if constexpr (kCoupled && !kBothInRegisters) {
    for (int first = 0; first < kParts; first += 2) repeat(rows.factor, u, first);
  }
  return rows.negative ? -1 : 1;
}

/// Gauss-Jordan elimination on [D | b c] and U together: b, c and U become D^-1 b, D^-1 c, D^-1 U, and D its inverse,
/// for further right-hand sides. U is not multiplied by the inverse: for a nearly inextensible line that would lose the
/// digits of its bending. Returns the sign of the determinant, 0 if singular.
template <bool kCoupled>
__attribute__((noinline)) int eliminate(Row* d, Row* u) {
  double max_entry = 0.0;
  for (int i = 0; i < kNodeDofs; ++i) {
    for (int j = 0; j < kNodeDofs; ++j) {
      max_entry = magnitude(d[i][j]) > max_entry ? magnitude(d[i][j]) : max_entry;
    }
  }
  int sign = 1;
  int swapped_with[kNodeDofs];
  for (int k = 0; k < kNodeDofs; ++k) {
    int pivot = k;
    for (int i = k + 1; i < kNodeDofs; ++i) {
      pivot = magnitude(d[i][k]) > magnitude(d[pivot][k]) ? i : pivot;
    }
    if (!(magnitude(d[pivot][k]) > kPivotFloor * max_entry)) {
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

/// Inverts a node's block D and replaces its coupling U with the next node by X = D^-1 U. Returns the sign of the
/// determinant, 0 if singular.
template <bool kCoupled>
inline int invert(Row* d, Row* u) {
  const int sign = eliminate_in_place<kCoupled>(d, u);
  return sign != 0 ? sign : eliminate<kCoupled>(d, u);
}

/// Returns the coupling columns of the next node with the right-hand sides appended.
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

/// Subtracts `back` times [X | x y] of this node from [D | b c] of the next one: `x` has both, see with_sides().
inline __attribute__((always_inline)) void update(Row* d_next, const double* back, const Row (&x)[kNodeDofs]) {
  for (int i = 0; i < kNodeDofs; ++i) {
    Row row = d_next[i];
    for (int k = 0; k < kNodeDofs; ++k) {
      row.subtract(back[i * kLanes + k], x[k]);
    }
    d_next[i] = row;
  }
}

/// Updates the next node through its coupling `back`.
inline __attribute__((always_inline)) void update_next_node(const Row* d, const Row* u, const double* back,
                                                            Row* d_next) {
  Row x[kNodeDofs];
  for (int i = 0; i < kNodeDofs; ++i) {
    x[i] = with_sides(u[i], d[i]);
  }
  update(d_next, back, x);
}

}  // namespace
}  // namespace overbend::OVERBEND_ISA_NAMESPACE
