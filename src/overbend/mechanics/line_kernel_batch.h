/// Vector algebra of the element kernel and its batch of elements. For line_kernel.cpp only: all code is in the unnamed
/// namespace of one instruction set.
///
/// Inside, the unknowns t are scaled by the element length, so that the Hermite functions are the same numbers for all
/// elements of a batch; force and tangent are scaled back at the end.
#pragma once

#include <utility>

#include "mechanics/lane_vectors.h"
#include "mechanics/line_kernel.h"
#include "mechanics/quadrature.h"

namespace overbend::OVERBEND_ISA_NAMESPACE {
namespace {

inline constexpr int kDofs = 12;
inline constexpr int kNodeDofs = 6;
inline constexpr int kRowWidth = 8;  ///< Row length of a block, see LineTarget.
inline constexpr int kBlockSize = kNodeDofs * kRowWidth;
inline constexpr double kPi = 3.14159265358979323846;

struct Sym {  ///< Symmetric 3x3.
  Lanes xx, xy, xz, yy, yz, zz;
};

struct Mat {
  Lanes m[3][3];
};

/// Cubic about the middle of the elements: c0 + c1 y + c2 y^2 + c3 y^3 with y = xi - 1/2, so that its value at a point
/// costs one constant per power.
struct Cubic {
  Vec c0, c1, c2, c3;
};

/// Returns the cubic of r1, h t1, r2, h t2, or of rates of these; `chord` is r2 - r1.
inline Cubic make_cubic(const Vec (&nodes)[4], const Vec& chord) {
  const Vec both = nodes[1] + nodes[3], turn = nodes[3] - nodes[1];
  return {0.5 * (nodes[0] + nodes[2]) - 0.125 * turn, 1.5 * chord - 0.25 * both, 0.5 * turn, both - 2.0 * chord};
}

inline Cubic make_cubic(const Vec (&nodes)[4]) {
  return make_cubic(nodes, nodes[2] - nodes[0]);
}

/// Returns the derivative with xi.
inline Vec cubic_slope(const Cubic& c, double y) {
  return c.c1 + y * (2.0 * c.c2 + (3.0 * y) * c.c3);
}

/// Gauss point: its distance y from the middle and the factors for cubics, their derivatives and forces.
struct GaussPoint {
  double y, y2, y3, twice_y, thrice_y2, six_y, weight;
};

constexpr GaussPoint gauss_point(double xi, double weight) {
  const double y = xi - 0.5;
  return {y, y * y, y * y * y, 2.0 * y, 3.0 * y * y, 6.0 * y, weight};
}

inline constexpr GaussPoint kGauss[kGaussPoints] = {
    gauss_point(kGaussXi[0], kGaussWeight[0]), gauss_point(kGaussXi[1], kGaussWeight[1]),
    gauss_point(kGaussXi[2], kGaussWeight[2]), gauss_point(kGaussXi[3], kGaussWeight[3])};

inline Vec value_at(const Cubic& c, const GaussPoint& p) {
  return c.c0 + p.y * c.c1 + p.y2 * c.c2 + p.y3 * c.c3;
}

/// Transformed unknowns of an element, used in its derivatives: mean (r1 + r2)/2 and turn h (t2 - t1), whose functions
/// are even about the middle; chord r2 - r1 and both h (t1 + t2), whose functions are odd. Derivatives along the
/// element depend on the last three only.
enum Unknown { kMean = 0, kTurn = 1, kChord = 2, kBoth = 3 };
inline constexpr int kSlopeDofs = 9;  ///< Turn, chord, both.

/// Values of these four functions at a point, and the first and second derivatives with xi of the last three.
struct Shape {
  double n[4], c[3], d[3];
};

constexpr Shape shape_at(double y) {
  return {{1.0, 0.5 * y * y - 0.125, 1.5 * y - 2.0 * y * y * y, y * y * y - 0.25 * y},
          {y, 1.5 - 6.0 * y * y, 3.0 * y * y - 0.25},
          {1.0, -12.0 * y, 6.0 * y}};
}

/// Gauss points are in pairs symmetric about the middle: function values are stored for the upper ones, 2 and 3.
inline constexpr int kGaussPairs = kGaussPoints / 2;
inline constexpr Shape kGaussShape[kGaussPairs] = {shape_at(kGauss[2].y), shape_at(kGauss[3].y)};

/// One register of elements: unknowns, intermediate values and forces.
struct Batch {
  Vec q[4];  ///< r1, h t1, r2, h t2.
  /// r2 - r1: derivatives depend on it only, and the difference keeps digits that are lost in positions of hundreds of
  /// metres.
  Vec chord;
  Lanes h, inv_h;
  Cubic r;            ///< Position.
  Vec a1, a2, a3;     ///< dr/ds of the unstressed length = a1 + a2 y + a3 y^2.
  Vec b0, b1;         ///< d2r/ds2 = b0 + b1 y.
  Vec by_cubic[4];    ///< Forces on c0 to c3 of the position,
  Vec by_tangent[2];  ///< and additional forces on h t1 and h t2.
};

/// Derivatives of the forces of a batch, each kind in its own form; joined at the end.
struct BatchTangent {
  Mat aa[kGaussPoints], bb[kGaussPoints];      ///< Bending, in slope and curvature, times the weight of the point,
  Mat ba[kGaussPoints];                        ///< and mixed terms: rows by the curvature.
  Lanes by_slope[kSlopeDofs][kSlopeDofs];      ///< Strains, symmetric: blocks on and above the diagonal.
  Lanes by_height[kSlopeDofs][3];              ///< Tension of pressure, in z of kMean, kTurn, kChord.
  Mat in_r[kGaussPoints], in_a[kGaussPoints];  ///< Loads, in position and slope, times the weight of the point.
  bool has_rates = false;                      ///< Set if elements are tension-only:
  Vec rate_rows[3], rate_columns[3];           ///< derivatives with the rates of the three strains, a column in a row.
  Lanes k[kDofs][kDofs];                       ///< Sum of all parts.
};

inline Lanes load_lanes(const double* p) {
  return *reinterpret_cast<const Lanes*>(p);
}

/// Number of registers for a row of kRow numbers, and first number of part kPart: the last part ends with the row if
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
    columns[l] = unaligned(rows + kRow * l + kStart);
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

/// Loads consecutive rows of kRow numbers into one register per number. Rows shorter than a register are read into the
/// next row: one more row must follow the last.
template <int kRow>
inline void load_rows(Lanes (&out)[kRow], const double* rows) {
  load_parts<kRow>(out, rows, std::make_integer_sequence<int, kRowParts<kRow>>());
}

inline constexpr int kNodeParts = kRowParts<kNodeDofs>;
/// Six numbers of every node of a batch in the layout of load_rows(): by part and node.
using NodeRows = Lanes[kNodeParts][kWidth];

template <int kPart>
inline void turn_part(NodeRows& rows, const Lanes (&values)[kNodeDofs]) {
  constexpr int kStart = kPartStart<kNodeDofs, kPart>;
  for (int j = 0; j < kWidth; ++j) {
    rows[kPart][j] = kStart + j < kNodeDofs ? values[kStart + j < kNodeDofs ? kStart + j : 0] : Lanes{};
  }
  transpose(rows[kPart]);
}

/// Part of a node's row that begins with a given number; the last part reaches to the end of the row.
template <int kFirst>
inline constexpr int kPartFrom = kWidth >= kNodeDofs                                    ? 0
                                 : kFirst % kWidth == 0 && kFirst + kWidth <= kNodeDofs ? kFirst / kWidth
                                                                                        : kNodeParts - 1;

/// Register kOut of the packed rows of a batch; I runs over its lanes.
template <int kOut, int... I>
inline Lanes packed_register(const NodeRows& rows, std::integer_sequence<int, I...> /*all*/) {
  constexpr int kNode = kOut * kWidth / kNodeDofs, kFirst = kOut * kWidth % kNodeDofs;
  constexpr int kPart = kPartFrom<kFirst>, kStart = kPartStart<kNodeDofs, kPart>;
  if constexpr (kFirst + kWidth <= kNodeDofs) {
    return rows[kPart][kNode];
  } else {
    return __builtin_shufflevector(rows[kPart][kNode], rows[0][kNode + 1],
                                   (kFirst + I < kNodeDofs ? kFirst + I - kStart : kWidth + kFirst + I - kNodeDofs)...);
  }
}

template <int... O>
inline void store_registers(double* to, const NodeRows& rows, std::integer_sequence<int, O...> /*registers*/) {
  constexpr auto lanes = std::make_integer_sequence<int, kWidth>();
  ((unaligned(to + kWidth * O) = packed_register<O>(rows, lanes)), ...);
}

template <int... P>
inline void turn_parts(NodeRows& rows, const Lanes (&values)[kNodeDofs], std::integer_sequence<int, P...> /*parts*/) {
  (turn_part<P>(rows, values), ...);
}

/// Inverse of load_rows(): stores the six numbers of every node consecutively.
inline void store_rows(double* to, const Lanes (&values)[kNodeDofs]) {
  NodeRows rows;
  turn_parts(rows, values, std::make_integer_sequence<int, kNodeParts>());
  store_registers(to, rows, std::make_integer_sequence<int, kNodeDofs>());
}

template <int... L>
inline Lanes lanes_from_next(const Lanes& x, double next, std::integer_sequence<int, L...> /*all*/) {
  return __builtin_shufflevector(x, Lanes{} + next, (L + 1)...);
}

/// Shifts lanes down: lane l receives lane l + 1, the last one `next`.
inline Lanes from_next(const Lanes& x, double next) {
  return lanes_from_next(x, next, std::make_integer_sequence<int, kWidth>());
}

template <int... L>
inline Lanes lanes_from_last(const Lanes& x, const Lanes& before, std::integer_sequence<int, L...> /*all*/) {
  return __builtin_shufflevector(x, before, (L == 0 ? 2 * kWidth - 1 : L - 1)...);
}

/// Shifts lanes up: lane l receives lane l - 1, the first one the last of `before`.
inline Lanes from_last(const Lanes& x, const Lanes& before) {
  return lanes_from_last(x, before, std::make_integer_sequence<int, kWidth>());
}

/// Gathers kRow numbers per node at both nodes of every element of a batch; lanes beyond the last element repeat it.
template <int kRow>
inline void gather_ends(Lanes (&lower)[kRow], Lanes (&upper)[kRow], const double* from, int first, int count) {
  const double* rows = from + kRow * first;
  if (first + kWidth <= count) {
    load_rows<kRow>(lower, rows);
    for (int i = 0; i < kRow; ++i) {
      upper[i] = from_next(lower[i], rows[kRow * kWidth + i]);
    }
    return;
  }
  double padded[2][kRow * (kWidth + 1)];
  for (int l = 0; l <= kWidth; ++l) {
    const double* node = from + kRow * (first + l < count ? first + l : count - 1);
    for (int i = 0; i < kRow; ++i) {
      padded[0][kRow * l + i] = node[i];
      padded[1][kRow * l + i] = node[kRow + i];
    }
  }
  load_rows<kRow>(lower, padded[0]);
  load_rows<kRow>(upper, padded[1]);
}

inline void gather_nodes(Vec (&out)[4], const double* from, int first, int count) {
  Lanes lower[kNodeDofs], upper[kNodeDofs];
  gather_ends<kNodeDofs>(lower, upper, from, first, count);
  for (int j = 0; j < 2; ++j) {
    out[j] = {lower[3 * j], lower[3 * j + 1], lower[3 * j + 2]};
    out[2 + j] = {upper[3 * j], upper[3 * j + 1], upper[3 * j + 2]};
  }
}

/// Computes position, slope and curvature polynomials from the unknowns of a batch.
inline void find_cubic(Batch& e) {
  e.r = make_cubic(e.q, e.chord);
  e.a1 = e.inv_h * e.r.c1;
  e.a2 = (2.0 * e.inv_h) * e.r.c2;
  e.a3 = (3.0 * e.inv_h) * e.r.c3;
  e.b0 = e.inv_h * e.a2;
  e.b1 = (2.0 * e.inv_h) * e.a3;
}

inline void clear_forces(Batch& e) {
  for (Vec& force : e.by_cubic) force = Vec{};
  for (Vec& force : e.by_tangent) force = Vec{};
}

/// Adds a force at a point.
inline void add_force(Batch& e, const GaussPoint& p, const Vec& f) {
  e.by_cubic[0] = e.by_cubic[0] + f;
  e.by_cubic[1] = e.by_cubic[1] + p.y * f;
  e.by_cubic[2] = e.by_cubic[2] + p.y2 * f;
  e.by_cubic[3] = e.by_cubic[3] + p.y3 * f;
}

/// Adds generalised forces at a point, conjugate to dr/d(xi) and d2r/d(xi)2.
inline void add_strain_force(Batch& e, const GaussPoint& p, const Vec& g, const Vec& m) {
  e.by_cubic[1] = e.by_cubic[1] + g;
  e.by_cubic[2] = e.by_cubic[2] + (p.twice_y * g + 2.0 * m);
  e.by_cubic[3] = e.by_cubic[3] + (p.thrice_y2 * g + p.six_y * m);
}

inline void put_components(Lanes* to, const Vec& v) {
  to[0] = v.x;
  to[1] = v.y;
  to[2] = v.z;
}

/// Returns all forces of a batch on r and t of its lower and upper nodes.
inline void nodal_forces(const Batch& e, Lanes (&lower)[kNodeDofs], Lanes (&upper)[kNodeDofs]) {
  const Vec by_chord = 1.5 * e.by_cubic[1] - 2.0 * e.by_cubic[3];
  const Vec by_both = e.by_cubic[3] - 0.25 * e.by_cubic[1];
  const Vec by_turn = 0.5 * e.by_cubic[2] - 0.125 * e.by_cubic[0];
  const Vec half = 0.5 * e.by_cubic[0];
  put_components(lower, half - by_chord);
  put_components(lower + 3, e.h * (by_both - by_turn + e.by_tangent[0]));
  put_components(upper, half + by_chord);
  put_components(upper + 3, e.h * (by_both + by_turn + e.by_tangent[1]));
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

inline void add_sym(Mat& m, const Lanes& scale, const Sym& s) {
  const Mat f = full(s);
  for (int r = 0; r < 3; ++r) {
    for (int c = 0; c < 3; ++c) {
      m.m[r][c] += scale * f.m[r][c];
    }
  }
}

}  // namespace
}  // namespace overbend::OVERBEND_ISA_NAMESPACE
