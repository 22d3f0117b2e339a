/// Bending and membrane of a batch with their exact derivatives. For line_kernel.cpp alone.
///
/// Strains are functions of derivatives along the element, which depend on h t1, the chord and h t2 alone. Their
/// tangent is collected by these nine, symmetric, and brought to all twelve unknowns once at the end
/// (line_kernel_tangent.h).
#pragma once

#include "mechanics/line_kernel_batch.h"

namespace overbend::OVERBEND_ISA_NAMESPACE {
namespace {

/// The centreline's derivative at a point of the elements.
struct PointSlope {
  Vec a;        ///< dr/ds of the unstressed length.
  Lanes inv_g;  ///< 1 / |a|^2.
};

inline PointSlope slope_at(const Batch& e, const Shape& s) {
  PointSlope at;
  at.a = e.inv_h * combine_derivative(e, s.c);
  at.inv_g = 1.0 / dot(at.a, at.a);
  return at;
}

/// Blocks of the derivatives' tangent: h t1, chord, h t2.
enum SlopeBlock { kLowerSlope = 0, kChord = 1, kUpperSlope = 2 };

/// Functions of a derivative by these three, from those by r1, h t1, r2, h t2: the chord's is that of r2.
inline constexpr int kSlopeNode[3] = {1, 2, 3};

/// u v'
inline Mat outer(const Vec& u, const Vec& v) {
  const Lanes uc[3] = {u.x, u.y, u.z}, vc[3] = {v.x, v.y, v.z};
  Mat m;
  for (int r = 0; r < 3; ++r) {
    for (int c = 0; c < 3; ++c) {
      m.m[r][c] = uc[r] * vc[c];
    }
  }
  return m;
}

inline Mat operator+(const Mat& a, const Mat& b) {
  Mat m;
  for (int r = 0; r < 3; ++r) {
    for (int c = 0; c < 3; ++c) {
      m.m[r][c] = a.m[r][c] + b.m[r][c];
    }
  }
  return m;
}

inline Mat operator*(double s, const Mat& a) {
  Mat m;
  for (int r = 0; r < 3; ++r) {
    for (int c = 0; c < 3; ++c) {
      m.m[r][c] = s * a.m[r][c];
    }
  }
  return m;
}

template <int kJ, int kK>
inline void set_slope_block(BatchTangent& tangent, const Mat& a) {
  for (int r = 0; r < 3; ++r) {
    for (int c = 0; c < 3; ++c) {
      tangent.by_slope[3 * kJ + r][3 * kK + c] = a.m[r][c];
    }
  }
}

/// Second derivatives of the bending energy at a point by a = dr/ds and b = d2r/ds2, blocks on and above the diagonal.
inline void add_bending_tangent(BatchTangent& tangent, const Shape& s, const Mat& aa, const Mat& ba, const Mat& bb) {
  for (int r = 0; r < 3; ++r) {
    for (int c = 0; c < 3; ++c) {
#pragma GCC unroll 3
      for (int k = 0; k < 3; ++k) {
        const double ck = s.c[kSlopeNode[k]], dk = s.d[kSlopeNode[k]];
        const Lanes x = ck * aa.m[r][c] + dk * ba.m[c][r];
        const Lanes y = ck * ba.m[r][c] + dk * bb.m[r][c];
#pragma GCC unroll 3
        for (int j = 0; j <= k; ++j) {
          tangent.by_slope[3 * j + r][3 * k + c] += s.c[kSlopeNode[j]] * x + s.d[kSlopeNode[j]] * y;
        }
      }
    }
  }
}

/// Of the energy EI/2 (b.b/g - (a.b)^2/g^2) per unstressed length at a Gauss point of weight `weight`, with g = a.a:
/// the square of the tangent's turning per unstressed length. `tangent` is null unless kTangent.
template <bool kTangent>
inline void add_bending(Batch& e, BatchTangent* tangent, const Shape& s, double weight, const Lanes& EI,
                        const PointSlope& at) {
  const Lanes inv_h2 = e.inv_h * e.inv_h;
  const Vec& a = at.a;
  const Vec b = inv_h2 * combine_derivative(e, s.d);
  const Lanes p = dot(b, b), m = dot(a, b);
  const Lanes ig = at.inv_g, ig2 = ig * ig, ig3 = ig2 * ig;
  const Lanes w = weight * EI;  // times h, one h lost to each derivative
  add_force(e, s.c, w * ((2.0 * m * m * ig3 - p * ig2) * a - (m * ig2) * b));
  add_force(e, s.d, (w * e.inv_h) * (ig * b - (m * ig2) * a));
  if constexpr (kTangent) {
    const Lanes wa = w * e.inv_h, wb = wa * inv_h2, wm = wa * e.inv_h;
    const Lanes mm = m * m;
    const Sym aa = dyads(wa * (2.0 * mm * ig3 - p * ig2), wa * (4.0 * p * ig3 - 12.0 * mm * ig3 * ig), a, -wa * ig2, b,
                         wa * 4.0 * m * ig3);
    const Sym bb = dyad(wb * ig, -wb * ig2, a);
    // W_ba = -2 b a'/g2 - a b'/g2 - m I/g2 + 4 m a a'/g3
    const Vec u = wm * ((4.0 * m * ig3) * a - (2.0 * ig2) * b);
    const Vec v = (-wm * ig2) * a;
    const Lanes diagonal = -wm * m * ig2;
    const Lanes ac[3] = {a.x, a.y, a.z}, bc[3] = {b.x, b.y, b.z}, uc[3] = {u.x, u.y, u.z}, vc[3] = {v.x, v.y, v.z};
    Mat ba;
    for (int r = 0; r < 3; ++r) {
      for (int c = 0; c < 3; ++c) {
        ba.m[r][c] = uc[r] * ac[c] + vc[r] * bc[c];
      }
      ba.m[r][r] += diagonal;
    }
    add_bending_tangent(*tangent, s, full(aa), ba, full(bb));
  }
}

struct PressureTension {
  Lanes constant, slope, external;
};

/// Height of water over z: that of the hydrostatic pressure with the head of the dynamic one.
inline Lanes water_over(const Lanes& z, const Lanes& head) {
  const Lanes depth = head - z;
  return depth > 0.0 ? depth : Lanes{};
}

/// Linear between the values at both ends.
inline Lanes mixed(const Lanes (&ends)[2], double xi) {
  return (1.0 - xi) * ends[0] + xi * ends[1];
}

/// Strains at the ends and the middle of the elements.
struct Membrane {
  Vec u[3];           ///< Unit tangents.
  Lanes inv_norm[3];  ///< 1 / |dr/ds|.
  Lanes strain[3];
  Lanes tension[3];        ///< Effective tension of pressure.
  Lanes tension_slope[3];  ///< Its derivative in z.
};

inline Membrane membrane_of(const Batch& e, const PressureTension& pressure, const Lanes (&head)[2]) {
  Membrane at;
  for (int k = 0; k < 3; ++k) {
    const Vec a = e.inv_h * combine_derivative(e, kStrainShape[k].c);
    const Lanes norm = root(dot(a, a));
    at.inv_norm[k] = 1.0 / norm;
    at.u[k] = at.inv_norm[k] * a;
    at.strain[k] = norm - 1.0;
    const Lanes z = combine(e, kStrainShape[k].n).z;
    const Lanes depth = water_over(z, mixed(head, 0.5 * k));
    at.tension[k] = pressure.constant + pressure.slope * z + pressure.external * depth;
    at.tension_slope[k] = pressure.slope - (depth > 0.0 ? pressure.external : Lanes{});
  }
  return at;
}

/// Derivative functions by h t1, chord and h t2 in the middle; at an end that of its own tangent is 1, the others 0.
inline constexpr double kMidTangent = kStrainShape[1].c[1], kMidChord = kStrainShape[1].c[2];
static_assert(kMidTangent == kStrainShape[1].c[3]);

/// By the strains' own stiffness and by the turning of their tangents under `force`: what the others add to comes
/// first.
inline void set_membrane_tangent(BatchTangent& tangent, const Batch& e, const Lanes& EA, const Membrane& at,
                                 const Lanes (&force)[3]) {
  const Lanes stiffness = EA * e.inv_h;
  const Vec &u0 = at.u[0], &u1 = at.u[1], &u2 = at.u[2];
  // What the strains' tensions are worth to a row: sums over its points times the mass.
  const auto of_mid = [&](int l) { return (stiffness * kStrainMass[1][l]) * u1; };
  const auto of_lower = [&](int l) { return (stiffness * kStrainMass[0][l]) * u0 + kMidTangent * of_mid(l); };
  const auto of_upper = [&](int l) { return (stiffness * kStrainMass[2][l]) * u2 + kMidTangent * of_mid(l); };
  const auto turning = [&](int k) {
    const Lanes geometric = force[k] * at.inv_norm[k] * e.inv_h;
    return full(dyad(geometric, -geometric, at.u[k]));
  };
  const Mat mid = turning(1);
  const Vec mid_tangent = kMidTangent * u1, mid_chord = kMidChord * u1;
  const Mat both_tangents = (kMidTangent * kMidTangent) * mid, both_chords = (kMidChord * kMidChord) * mid,
            tangent_chord = (kMidTangent * kMidChord) * mid;
  set_slope_block<kLowerSlope, kLowerSlope>(
      tangent, outer(of_lower(0), u0) + outer(of_lower(1), mid_tangent) + turning(0) + both_tangents);
  set_slope_block<kLowerSlope, kChord>(tangent, outer(of_lower(1), mid_chord) + tangent_chord);
  set_slope_block<kLowerSlope, kUpperSlope>(tangent,
                                            outer(of_lower(1), mid_tangent) + outer(of_lower(2), u2) + both_tangents);
  set_slope_block<kChord, kChord>(tangent, outer(kMidChord * of_mid(1), mid_chord) + both_chords);
  set_slope_block<kChord, kUpperSlope>(
      tangent, outer(kMidChord * of_mid(1), mid_tangent) + outer(kMidChord * of_mid(2), u2) + tangent_chord);
  set_slope_block<kUpperSlope, kUpperSlope>(
      tangent, outer(of_upper(1), mid_tangent) + outer(of_upper(2), u2) + turning(2) + both_tangents);
}

/// By the tension of pressure, which changes with the height of the strains' points: unsymmetric.
inline void set_pressure_tangent(BatchTangent& tangent, const Membrane& at) {
  const auto set = [&tangent](int row, int node, const Vec& q) {
    tangent.by_height[3 * row][node] = q.x;
    tangent.by_height[3 * row + 1][node] = q.y;
    tangent.by_height[3 * row + 2][node] = q.z;
  };
  for (int node = 0; node < 4; ++node) {
    Vec q[3];
    for (int k = 0; k < 3; ++k) {
      Lanes by_height = (kStrainMass[k][1] * kStrainShape[1].n[node]) * at.tension_slope[1];
      if (node == 0) {
        by_height += kStrainMass[k][0] * at.tension_slope[0];
      } else if (node == 2) {
        by_height += kStrainMass[k][2] * at.tension_slope[2];
      }
      q[k] = by_height * at.u[k];
    }
    const Vec chord = kMidChord * q[1], mid = kMidTangent * q[1];
    set(0, node, -1.0 * chord);
    set(1, node, q[0] + mid);
    set(2, node, chord);
    set(3, node, q[2] + mid);
  }
}

/// Membrane with the effective tension of pressure, which varies with depth. `head` of the dynamic pressure at both
/// ends. `tangent` is null unless kTangent.
template <bool kTangent>
inline void add_membrane(Batch& e, BatchTangent* tangent, const Lanes& EA, const PressureTension& pressure,
                         const Lanes (&head)[2]) {
  const Membrane at = membrane_of(e, pressure, head);
  Lanes force[3], tension[3];
  for (int l = 0; l < 3; ++l) {
    tension[l] = EA * at.strain[l] + at.tension[l];
  }
  for (int k = 0; k < 3; ++k) {
    force[k] = kStrainMass[k][0] * tension[0] + kStrainMass[k][1] * tension[1] + kStrainMass[k][2] * tension[2];
  }
  // times h, over h
  add_node_force(e, 1, force[0] * at.u[0]);
  add_force(e, kStrainShape[1].c, force[1] * at.u[1]);
  add_node_force(e, 3, force[2] * at.u[2]);
  if constexpr (kTangent) {
    set_membrane_tangent(*tangent, e, EA, at, force);
    set_pressure_tangent(*tangent, at);
  }
}

}  // namespace
}  // namespace overbend::OVERBEND_ISA_NAMESPACE
