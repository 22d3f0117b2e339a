/// Vector algebra of the element kernel and the batch of elements it works on. For line_kernel.cpp alone: everything
/// stands in the unnamed namespace of one instruction set.
///
/// Inside, the unknowns t are scaled by the element length, so that the Hermite functions are the same numbers for all
/// elements of a batch; force and tangent are scaled back at the end.
#pragma once

#if defined(__SSE2__)
#include <immintrin.h>
#endif

#include <utility>

#include "base/simd.h"
#include "mechanics/line_kernel.h"
#include "mechanics/quadrature.h"

namespace overbend::OVERBEND_ISA_NAMESPACE {
namespace {

inline constexpr int kDofs = 12;
inline constexpr double kPi = 3.14159265358979323846;

struct Vec {
  Lanes x, y, z;
};

struct Sym {  ///< Symmetric 3x3.
  Lanes xx, xy, xz, yy, yz, zz;
};

struct Mat {
  Lanes m[3][3];
};

inline Lanes all(double value) {
  return Lanes{} + value;
}
inline Vec operator+(const Vec& a, const Vec& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
inline Vec operator-(const Vec& a, const Vec& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
inline Vec operator*(const Lanes& s, const Vec& a) {
  return {s * a.x, s * a.y, s * a.z};
}
inline Vec operator*(double s, const Vec& a) {
  return {s * a.x, s * a.y, s * a.z};
}
inline Lanes dot(const Vec& a, const Vec& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

/// Whether any lane is above zero.
inline bool any(const Lanes& x) {
#if defined(__AVX512F__)
  return _mm512_cmp_pd_mask(x, _mm512_setzero_pd(), _CMP_GT_OQ) != 0;
#elif defined(__AVX__)
  return _mm256_movemask_pd(_mm256_cmp_pd(x, _mm256_setzero_pd(), _CMP_GT_OQ)) != 0;
#elif defined(__SSE2__)
  return _mm_movemask_pd(_mm_cmpgt_pd(x, _mm_setzero_pd())) != 0;
#else
  bool found = false;
  for (int l = 0; l < kWidth; ++l) {
    found = found || x[l] > 0.0;
  }
  return found;
#endif
}

inline Lanes root(const Lanes& a) {
  Lanes r;
  for (int l = 0; l < kWidth; ++l) {
    r[l] = __builtin_sqrt(a[l]);
  }
  return r;
}

/// Hermite functions of (r1, h t1, r2, h t2) at xi: values, first derivatives times h, second times h^2.
struct Shape {
  double n[4], c[4], d[4];
};

constexpr Shape shape_at(double x) {
  return {{1 - 3 * x * x + 2 * x * x * x, x - 2 * x * x + x * x * x, 3 * x * x - 2 * x * x * x, x * x * x - x * x},
          {-6 * x + 6 * x * x, 1 - 4 * x + 3 * x * x, 6 * x - 6 * x * x, 3 * x * x - 2 * x},
          {-6 + 12 * x, -4 + 6 * x, 6 - 12 * x, 6 * x - 2}};
}

inline constexpr Shape kGaussShape[kGaussPoints] = {shape_at(kGaussXi[0]), shape_at(kGaussXi[1]), shape_at(kGaussXi[2]),
                                                    shape_at(kGaussXi[3])};
inline constexpr Shape kStrainShape[3] = {shape_at(0.0), shape_at(0.5), shape_at(1.0)};

inline constexpr int kNodeDofs = 6;
inline constexpr int kRowWidth = 8;  ///< Of a row of a block, see LineTarget.
inline constexpr int kBlockSize = kNodeDofs * kRowWidth;
inline constexpr int kSlopeDofs = 9;  ///< h t1, chord, h t2: what derivatives along the element depend on.

/// As many elements as a register holds: unknowns, constants, force and tangent.
struct Batch {
  Vec q[4];   ///< r1, h t1, r2, h t2.
  Vec chord;  ///< r2 - r1: derivatives need no more, and the difference keeps digits that positions of hundreds of
              ///< metres lose.
  Lanes h, inv_h;
  Lanes f[kDofs];
};

/// Derivatives of the forces of a batch, of each kind in the form it comes in: joined at the end.
struct BatchTangent {
  Lanes by_slope[kSlopeDofs][kSlopeDofs];  ///< Of strains, symmetric: at first the blocks on and above the diagonal.
  Lanes by_height[kDofs][4];               ///< Of the tension of pressure, in z of r1, h t1, r2, h t2.
  Mat in_r[kGaussPoints], in_a[kGaussPoints];  ///< Of loads, in place and slope, times the point's weight.
  Lanes k[kDofs][kDofs];                       ///< All together.
};

using LooseLanes = double __attribute__((vector_size(8 * kWidth), may_alias, aligned(8)));

inline Lanes load_lanes(const double* p) {
  return *reinterpret_cast<const Lanes*>(p);
}

/// One stage of a transposition: blocks of kStep lanes change places between rows that are kStep apart. L runs over the
/// lanes.
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

/// Lane l of row j becomes lane j of row l.
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

/// How many registers a row of kRow numbers takes, and where part number kPart begins: the last ends with the row, if
/// the row fills a register.
template <int kRow>
inline constexpr int kRowParts = (kRow + kWidth - 1) / kWidth;
template <int kRow, int kPart>
inline constexpr int kPartStart = kRow < kWidth || (kPart + 1) * kWidth <= kRow ? kPart* kWidth : kRow - kWidth;

template <int kRow, int kPart>
inline void load_part(Lanes (&out)[kRow], const double* rows) {
  constexpr int kStart = kPartStart<kRow, kPart>;
  Lanes columns[kWidth];
  for (int l = 0; l < kWidth; ++l) {
    columns[l] = *reinterpret_cast<const LooseLanes*>(rows + kRow * l + kStart);
  }
  transpose(columns);
  for (int j = 0; j < kWidth && kStart + j < kRow; ++j) {
    out[kStart + j] = columns[j];
  }
}

template <int kRow, int... P>
inline void load_parts(Lanes (&out)[kRow], const double* rows, std::integer_sequence<int, P...> /*parts*/) {
  (load_part<kRow, P>(out, rows), ...);
}

/// Rows of kRow numbers, one after the other, to a register for each number. Rows shorter than a register are read on
/// into the next: there must be one after the last.
template <int kRow>
inline void load_rows(Lanes (&out)[kRow], const double* rows) {
  load_parts<kRow>(out, rows, std::make_integer_sequence<int, kRowParts<kRow>>());
}

template <int kPart>
inline void pack_part(double* packed, const Lanes (&values)[kNodeDofs]) {
  constexpr int kStart = kPartStart<kNodeDofs, kPart>;
  Lanes rows[kWidth];
  for (int j = 0; j < kWidth; ++j) {
    rows[j] = kStart + j < kNodeDofs ? values[kStart + j < kNodeDofs ? kStart + j : 0] : Lanes{};
  }
  transpose(rows);
  for (int l = 0; l < kWidth; ++l) {
    *reinterpret_cast<LooseLanes*>(packed + kNodeDofs * l + kStart) = rows[l];
  }
}

template <int... P>
inline void pack_parts(double* packed, const Lanes (&values)[kNodeDofs], std::integer_sequence<int, P...> /*parts*/) {
  (pack_part<P>(packed, values), ...);
}

/// The way back, to kWidth * kNodeDofs numbers and up to two more that have no meaning.
inline void pack_rows(double* packed, const Lanes (&values)[kNodeDofs]) {
  pack_parts(packed, values, std::make_integer_sequence<int, kRowParts<kNodeDofs>>());
}

template <int... L>
inline Lanes lanes_from_next(const Lanes& x, double next, std::integer_sequence<int, L...> /*all*/) {
  return __builtin_shufflevector(x, Lanes{} + next, (L + 1)...);
}

/// Lane l receives that of l + 1, the last `next`.
inline Lanes from_next(const Lanes& x, double next) {
  return lanes_from_next(x, next, std::make_integer_sequence<int, kWidth>());
}

template <int... L>
inline Lanes lanes_from_last(const Lanes& x, const Lanes& before, std::integer_sequence<int, L...> /*all*/) {
  return __builtin_shufflevector(x, before, (L == 0 ? 2 * kWidth - 1 : L - 1)...);
}

/// Lane l receives that of l - 1, the first the last of `before`.
inline Lanes from_last(const Lanes& x, const Lanes& before) {
  return lanes_from_last(x, before, std::make_integer_sequence<int, kWidth>());
}

/// Values of six per node at both nodes of every element of a batch; beyond the last element, of the last.
inline void gather_nodes(Vec (&out)[4], const double* from, int first, int count) {
  Lanes lower[kNodeDofs] = {}, upper[kNodeDofs] = {};
  if (first + kWidth <= count) {
    load_rows<kNodeDofs>(lower, from + kNodeDofs * first);
    for (int i = 0; i < kNodeDofs; ++i) {
      upper[i] = from_next(lower[i], from[kNodeDofs * (first + kWidth) + i]);
    }
  } else {
    for (int l = 0; l < kWidth; ++l) {
      const double* node = from + kNodeDofs * (first + l < count ? first + l : count - 1);
      for (int i = 0; i < kNodeDofs; ++i) {
        lower[i][l] = node[i];
        upper[i][l] = node[kNodeDofs + i];
      }
    }
  }
  for (int j = 0; j < 2; ++j) {
    out[j] = {lower[3 * j], lower[3 * j + 1], lower[3 * j + 2]};
    out[2 + j] = {upper[3 * j], upper[3 * j + 1], upper[3 * j + 2]};
  }
}

inline Vec combine(const Batch& e, const double (&s)[4]) {
  return s[0] * e.q[0] + s[1] * e.q[1] + s[2] * e.q[2] + s[3] * e.q[3];
}

/// A derivative of the centreline: the functions of r1 and r2 are opposite.
inline Vec combine_derivative(const Batch& e, const double (&s)[4]) {
  return s[1] * e.q[1] + s[2] * e.chord + s[3] * e.q[3];
}

/// A force at a point, through the functions of all four.
inline void add_force(Batch& e, const double (&by)[4], const Vec& v) {
  for (int j = 0; j < 4; ++j) {
    e.f[3 * j] += by[j] * v.x;
    e.f[3 * j + 1] += by[j] * v.y;
    e.f[3 * j + 2] += by[j] * v.z;
  }
}

/// To one of r1, h t1, r2, h t2.
inline void add_node_force(Batch& e, int j, const Vec& v) {
  e.f[3 * j] += v.x;
  e.f[3 * j + 1] += v.y;
  e.f[3 * j + 2] += v.z;
}

inline Mat full(const Sym& s) {
  return {{{s.xx, s.xy, s.xz}, {s.xy, s.yy, s.yz}, {s.xz, s.yz, s.zz}}};
}

/// alpha I + beta a a' + gamma b b' + delta (a b' + b a')
inline Sym dyads(const Lanes& alpha, const Lanes& beta, const Vec& a, const Lanes& gamma, const Vec& b,
                 const Lanes& delta) {
  const Vec u = beta * a + delta * b;
  const Vec v = gamma * b + delta * a;
  return {alpha + u.x * a.x + v.x * b.x, u.x * a.y + v.x * b.y, u.x * a.z + v.x * b.z,
          alpha + u.y * a.y + v.y * b.y, u.y * a.z + v.y * b.z, alpha + u.z * a.z + v.z * b.z};
}

/// alpha I + beta a a'
inline Sym dyad(const Lanes& alpha, const Lanes& beta, const Vec& a) {
  const Vec u = beta * a;
  return {alpha + u.x * a.x, u.x * a.y, u.x * a.z, alpha + u.y * a.y, u.y * a.z, alpha + u.z * a.z};
}

}  // namespace
}  // namespace overbend::OVERBEND_ISA_NAMESPACE
