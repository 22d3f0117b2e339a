#include "numerics/block_tridiagonal_kernel.h"

#include <utility>

#include "base/simd.h"

namespace overbend::OVERBEND_ISA_NAMESPACE {
namespace {

inline double magnitude(double x) {
  return x < 0.0 ? -x : x;
}

static_assert(kRowWidth == kLanes, "a row of a block is one batch of lanes");
constexpr int kParts = kLanes / kWidth;

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
constexpr double kPivotFloor = 1e-14;

/// Rows are exchanged where a pivot is smaller than this fraction of the entries below it, or of its initial value.
constexpr double kPivotShare = 0.02;
constexpr double kPivotLoss = 1e-10;

/// The twelve rows of a block and its neighbour, all of them in registers.
struct BlockRows {
  Row d[kNodeDofs], u[kNodeDofs];
};

/// Takes out row I by the pivot row K, already scaled.
template <int K, int I>
inline __attribute__((always_inline)) void take_out(BlockRows& rows) {
  if constexpr (I != K) {
    const double factor = rows.d[I].part[K / kWidth][K % kWidth];
    rows.d[I].part[K / kWidth][K % kWidth] = 0.0;
    rows.d[I].subtract(factor, rows.d[K]);
    rows.u[I].subtract(factor, rows.u[K]);
  }
}

/// Whether the pivot of K may stay where it is. I runs over all rows.
template <int K, int I>
inline __attribute__((always_inline)) bool outweighs(const BlockRows& rows, double pivot) {
  return I <= K || kPivotShare * magnitude(rows.d[I].part[K / kWidth][K % kWidth]) <= magnitude(pivot);
}

template <int K, int... I>
inline __attribute__((always_inline)) void eliminate_row(BlockRows& rows, const double* at_first, int& sign, bool& good,
                                                         std::integer_sequence<int, I...> /*all*/) {
  const double pivot = rows.d[K].part[K / kWidth][K % kWidth];
  good = good & (magnitude(pivot) > kPivotLoss * magnitude(at_first[K])) & (outweighs<K, I>(rows, pivot) & ...);
  sign = pivot < 0.0 ? -sign : sign;
  const double inverse = 1.0 / pivot;
  rows.d[K].part[K / kWidth][K % kWidth] = 1.0;
  rows.d[K].scale(inverse);
  rows.u[K].scale(inverse);
  (take_out<K, I>(rows), ...);
}

template <int... K>
inline __attribute__((always_inline)) int eliminate_rows(BlockRows& rows, const double* at_first,
                                                         std::integer_sequence<int, K...> all) {
  int sign = 1;
  bool good = true;
  (eliminate_row<K>(rows, at_first, sign, good, all), ...);
  return good ? sign : 0;
}

/// What `eliminate` does, without exchanging rows: most blocks need none, and then nothing has to wait for memory.
/// Returns 0 and leaves everything as it was where some row should be exchanged.
inline int eliminate_in_place(Row* d, Row* u) {
  BlockRows rows;
  double at_first[kNodeDofs];
  for (int i = 0; i < kNodeDofs; ++i) {
    rows.d[i] = d[i];
    rows.u[i] = u[i];
    at_first[i] = d[i][i];
  }
  const int sign = eliminate_rows(rows, at_first, std::make_integer_sequence<int, kNodeDofs>());
  if (sign != 0) {
    for (int i = 0; i < kNodeDofs; ++i) {
      d[i] = rows.d[i];
      u[i] = rows.u[i];
    }
  }
  return sign;
}

/// Gauss-Jordan on [D | b c] and U together: b, c and U become D^-1 b, D^-1 c, D^-1 U, and D its inverse, which serves
/// further right-hand sides. Returns the sign of the determinant, 0 when singular.
int eliminate(Row* d, Row* u) {
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
      const Row d_row = d[k];
      const Row u_row = u[k];
      d[k] = d[pivot];
      u[k] = u[pivot];
      d[pivot] = d_row;
      u[pivot] = u_row;
      sign = -sign;
    }
    sign = d[k][k] < 0.0 ? -sign : sign;
    const double inverse = 1.0 / d[k][k];
    d[k][k] = 1.0;
    d[k].scale(inverse);
    u[k].scale(inverse);
    for (int i = 0; i < kNodeDofs; ++i) {
      if (i != k) {
        const double factor = d[i][k];
        d[i][k] = 0.0;
        d[i].subtract(factor, d[k]);
        u[i].subtract(factor, u[k]);
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

/// [D | b c] of the next node loses L times [X | x y] of this one.
inline void update_next(Row* d_next, const double* lower, const Row* d, Row* u) {
  for (int k = 0; k < kNodeDofs; ++k) {
    u[k][6] = d[k][6];
    u[k][7] = d[k][7];
  }
  for (int i = 0; i < kNodeDofs; ++i) {
    Row row = d_next[i];
    for (int k = 0; k < kNodeDofs; ++k) {
      row.subtract(lower[i * kLanes + k], u[k]);
    }
    d_next[i] = row;
  }
}

inline void substitute_back(Row* d, const Row* u, const Row* d_next) {
  for (int i = 0; i < kNodeDofs; ++i) {
    double x = d[i][6];
    double y = d[i][7];
    for (int k = 0; k < kNodeDofs; ++k) {
      x -= u[i][k] * d_next[k][6];
      y -= u[i][k] * d_next[k][7];
    }
    d[i][6] = x;
    d[i][7] = y;
  }
}

/// y = A x for the first six columns.
inline void multiply(const double* a, const double* x, double* y) {
  for (int i = 0; i < kNodeDofs; ++i) {
    double sum = a[i * kLanes] * x[0];
    for (int k = 1; k < kNodeDofs; ++k) {
      sum += a[i * kLanes + k] * x[k];
    }
    y[i] = sum;
  }
}

inline Row* rows(double* blocks, int node) {
  return reinterpret_cast<Row*>(blocks + node * kBlockSize);
}

}  // namespace

BlockSolveReport factor_blocks(const BlockView& system, int first) {
  BlockSolveReport report;
  const int n = system.nodes;
  if (first > 0) {
    update_next(rows(system.diag, first), system.lower + (first - 1) * kBlockSize, rows(system.diag, first - 1),
                rows(system.upper, first - 1));
  }
  for (int i = first; i < n; ++i) {
    Row* d = rows(system.diag, i);
    Row* u = rows(system.upper, i);
    int sign = eliminate_in_place(d, u);
    sign = sign != 0 ? sign : eliminate(d, u);
    if (sign == 0) {
      report.singular_node = i;
      return report;
    }
    report.negative_blocks += sign < 0 ? 1 : 0;
    if (i + 1 < n) {
      update_next(rows(system.diag, i + 1), system.lower + i * kBlockSize, d, u);
    }
  }
  return report;
}

BlockSolveReport solve_blocks(const BlockView& system) {
  const BlockSolveReport report = factor_blocks(system, 0);
  if (!report.solved()) {
    return report;
  }
  for (int i = system.nodes - 2; i >= 0; --i) {
    substitute_back(rows(system.diag, i), rows(system.upper, i), rows(system.diag, i + 1));
  }
  return report;
}

void resolve_blocks(const BlockView& system, double* x) {
  const int n = system.nodes;
  double product[kNodeDofs];
  for (int i = 0; i < n; ++i) {
    double* at = x + i * kNodeDofs;
    if (i > 0) {
      multiply(system.lower + (i - 1) * kBlockSize, at - kNodeDofs, product);
      for (int k = 0; k < kNodeDofs; ++k) {
        at[k] -= product[k];
      }
    }
    multiply(system.diag + i * kBlockSize, at, product);
    for (int k = 0; k < kNodeDofs; ++k) {
      at[k] = product[k];
    }
  }
  for (int i = n - 2; i >= 0; --i) {
    double* at = x + i * kNodeDofs;
    multiply(system.upper + i * kBlockSize, at + kNodeDofs, product);
    for (int k = 0; k < kNodeDofs; ++k) {
      at[k] -= product[k];
    }
  }
}

}  // namespace overbend::OVERBEND_ISA_NAMESPACE
