/// Bending and membrane of a batch with their exact derivatives. For line_kernel.cpp only.
///
/// Strains are functions of derivatives along the element, which depend on turn, chord and both (see Unknown) only.
/// Their tangent is accumulated in these nine, symmetric, and transformed to all twelve unknowns once at the end
/// (line_kernel_tangent.h).
#pragma once

#include "mechanics/line_kernel_batch.h"
#include "mechanics/slack_law.h"

namespace overbend::OVERBEND_ISA_NAMESPACE {
namespace {

/// Derivatives of the centreline with the unstressed length at a point of the elements.
struct PointSlope {
  Vec a, b;     ///< dr/ds, d2r/ds2
  Lanes inv_g;  ///< 1 / |a|^2.
  Lanes inv_norm;
};

inline PointSlope slope_at(const Batch& e, const GaussPoint& p) {
  PointSlope slope;
  slope.a = e.a1 + p.y * e.a2 + p.y2 * e.a3;
  slope.b = e.b0 + p.y * e.b1;
  slope.inv_g = 1.0 / dot(slope.a, slope.a);
  slope.inv_norm = root(slope.inv_g);
  return slope;
}

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

/// Adds the forces of the energy EI/2 (b.b/g - (a.b)^2/g^2) per unstressed length at Gauss point i, with g = a.a: the
/// square of the tangent's rotation per unstressed length. With the part n of b across the pipe it is EI/2 n.n/g, and
/// its derivatives are n/g in b and -(n.n/g a + a.b/g n)/g in a. `tangent` is null unless kTangent. Returns twice the
/// energy, per length.
template <bool kTangent>
inline Lanes add_bending(Batch& e, BatchTangent* tangent, int i, const Lanes& EI, const PointSlope& slope) {
  const Vec &a = slope.a, &b = slope.b;
  const Lanes ig = slope.inv_g, m = dot(a, b), along = m * ig;
  const Vec n = b - along * a;
  const Lanes w = kGauss[i].weight * EI;  // times h, one h cancels in each derivative
  const Vec by_b = (w * ig) * n;
  const Lanes twice_energy = dot(by_b, n);
  add_strain_force(e, kGauss[i], (-ig * twice_energy) * a - along * by_b, e.inv_h * by_b);
  if constexpr (kTangent) {
    const Lanes inv_h2 = e.inv_h * e.inv_h, ig2 = ig * ig, ig3 = ig2 * ig, p = dot(b, b);
    const Lanes wa = w * e.inv_h, wb = wa * inv_h2, wm = wa * e.inv_h;
    const Lanes mm = m * m;
    tangent->aa[i] = full(dyads(wa * (2.0 * mm * ig3 - p * ig2), wa * (4.0 * p * ig3 - 12.0 * mm * ig3 * ig), a,
                                -wa * ig2, b, wa * 4.0 * m * ig3));
    tangent->bb[i] = full(dyad(wb * ig, -wb * ig2, a));
    // W_ba = -2 b a'/g2 - a b'/g2 - m I/g2 + 4 m a a'/g3
    const Vec u = wm * ((4.0 * m * ig3) * a - (2.0 * ig2) * b);
    const Vec v = (-wm * ig2) * a;
    const Lanes diagonal = -wm * m * ig2;
    const Lanes ac[3] = {a.x, a.y, a.z}, bc[3] = {b.x, b.y, b.z}, uc[3] = {u.x, u.y, u.z}, vc[3] = {v.x, v.y, v.z};
    Mat& ba = tangent->ba[i];
    for (int r = 0; r < 3; ++r) {
      for (int c = 0; c < 3; ++c) {
        ba.m[r][c] = uc[r] * ac[c] + vc[r] * bc[c];
      }
      ba.m[r][r] += diagonal;
    }
  }
  return twice_energy;
}

struct PressureTension {
  Lanes constant, slope, external;
};

/// Height of water above z: hydrostatic plus dynamic pressure head.
inline Lanes water_over(const Lanes& z, const Lanes& head) {
  const Lanes depth = head - z;
  return depth > 0.0 ? depth : Lanes{};
}

/// Interpolates linearly between the values at both ends.
inline Lanes mixed(const Lanes (&ends)[2], double xi) {
  return (1.0 - xi) * ends[0] + xi * ends[1];
}

/// Strains at the ends and the middle of the elements, with the pressure including the dynamic `head` at both ends.
struct Membrane {
  Vec u[3];           ///< Unit tangents.
  Lanes inv_norm[3];  ///< 1 / |dr/ds|.
  Lanes strain[3];
  Lanes tension[3];        ///< Effective tension from pressure.
  Lanes tension_slope[3];  ///< Its derivative in z.
  // Only for tension-only elements:
  Lanes rate[3];   ///< Rates of the strains [1/s].
  Vec turning[3];  ///< Rate of the unit tangents with xi: derivative of the strain rates with the slopes.
};

/// Sets the strain rates; `velocity` are the slopes of the velocity with xi.
inline void set_rates(Membrane& membrane, const Batch& e, const Vec (&velocity)[3]) {
  for (int k = 0; k < 3; ++k) {
    const Vec slope = e.inv_h * velocity[k];
    membrane.rate[k] = dot(membrane.u[k], slope);
    membrane.turning[k] = membrane.inv_norm[k] * (slope - membrane.rate[k] * membrane.u[k]);
  }
}

inline void set_no_rates(Membrane& membrane) {
  for (int k = 0; k < 3; ++k) {
    membrane.rate[k] = Lanes{};
    membrane.turning[k] = Vec{};
  }
}

/// Axial constants of a batch.
struct AxialConstants {
  Lanes EA, share, damping;
  double velocity_share;  ///< Derivative of a velocity with its unknown [1/s].

  /// True if any element is tension-only.
  bool slack() const { return any(1.0 - share); }
};

inline Membrane make_membrane(const Batch& e, const PressureTension& pressure, const Lanes (&head)[2]) {
  Membrane membrane;
  const Vec slope[3] = {e.inv_h * e.q[1], e.a1, e.inv_h * e.q[3]};
  const Lanes z[3] = {e.q[0].z, e.r.c0.z, e.q[2].z};
  for (int k = 0; k < 3; ++k) {
    const Lanes norm = root(dot(slope[k], slope[k]));
    membrane.inv_norm[k] = 1.0 / norm;
    membrane.u[k] = membrane.inv_norm[k] * slope[k];
    membrane.strain[k] = norm - 1.0;
    const Lanes depth = water_over(z[k], mixed(head, 0.5 * k));
    membrane.tension[k] = pressure.constant + pressure.slope * z[k] + pressure.external * depth;
    membrane.tension_slope[k] = pressure.slope - (depth > 0.0 ? pressure.external : Lanes{});
  }
  return membrane;
}

/// Coefficients of dr/d(xi) in the middle for chord and both. At the ends it is (both -+ turn)/2.
inline constexpr double kMidChord = 1.5, kMidBoth = -0.25;

inline void set_slope_block(BatchTangent& tangent, int j, int k, const Mat& a) {
  for (int r = 0; r < 3; ++r) {
    for (int c = 0; c < 3; ++c) {
      tangent.by_slope[3 * j + r][3 * k + c] = a.m[r][c];
    }
  }
}

/// Forces of the three strains over h, each including the coupling to the others, and their derivatives with the
/// strains.
struct StrainForces {
  Lanes force[3], slope[3][3];
  Lanes by_rate[3];  ///< Derivative of each force with its own rate; set for tension-only elements.
};

/// Tension-only law over EA: force and its slope.
struct SlackLaw {
  Lanes force, slope;
};

/// Position in the transition of the pulling part from zero, 0, to the line N = EA e, 1.
inline Lanes taut_fraction(const Lanes& strain) {
  const Lanes grown = (0.5 / kSlackStrain) * strain + 0.5;
  const Lanes above = grown > 0.0 ? grown : Lanes{};
  return above < 1.0 ? above : all(1.0);
}

/// Tension-only part, before its share.
inline SlackLaw tension_only_law(const Lanes& strain) {
  const Lanes x = taut_fraction(strain);
  return {x < 1.0 ? kSlackStrain * x * x : strain, x};
}

/// Part effective in compression, before its share.
inline SlackLaw compression_law(const Lanes& strain) {
  const Lanes x = 1.0 + strain, inverse = 1.0 / (x * x);
  return {0.25 * x * (1.0 - inverse * inverse), 0.25 + 0.75 * inverse * inverse};
}

/// Returns twice the energy of both parts.
inline Lanes twice_slack_energy(const Lanes& strain, const Lanes& share) {
  constexpr double kThird = kSlackStrain * kSlackStrain / 3.0;
  const Lanes x = taut_fraction(strain), length = 1.0 + strain, squared = length * length;
  const Lanes stored = x < 1.0 ? 4.0 * kThird * x * x * x : strain * strain + kThird;
  return 0.25 * share * (squared + 1.0 / squared - 2.0) + (1.0 - share) * stored;
}

inline void add_pressure(StrainForces& f, const Membrane& membrane) {
  for (int k = 0; k < 3; ++k) {
    f.force[k] += kStrainMass[k][0] * membrane.tension[0] + kStrainMass[k][1] * membrane.tension[1] +
                  kStrainMass[k][2] * membrane.tension[2];
  }
}

/// Forces of a pipe, linear in tension and compression.
inline StrainForces linear_forces(const Membrane& membrane, const Lanes& EA) {
  StrainForces f;
  for (int k = 0; k < 3; ++k) {
    f.force[k] = Lanes{};
    for (int l = 0; l < 3; ++l) {
      f.slope[k][l] = kStrainMass[k][l] * EA;
      f.force[k] += f.slope[k][l] * membrane.strain[l];
    }
  }
  return f;
}

/// Forces of a batch with tension-only elements (slack_law.h).
inline __attribute__((noinline)) StrainForces forces_with_slack(const Membrane& membrane, const AxialConstants& axial) {
  StrainForces f = linear_forces(membrane, axial.EA);
  const Lanes rest = 1.0 - axial.share;
  for (int k = 0; k < 3; ++k) {
    const SlackLaw left = compression_law(membrane.strain[k]),
                   pulls = tension_only_law(membrane.strain[k] + axial.damping * membrane.rate[k]);
    const Lanes weight = kSlackWeight[k] * axial.EA, pulling = weight * rest, pushed = weight * axial.share;
    const Lanes slope = pulling * pulls.slope;
    const Lanes pushed_slope = pushed * left.slope + (1.0 + axial.velocity_share * axial.damping) * slope;
    f.force[k] = rest > 0.0 ? pushed * left.force + pulling * pulls.force : f.force[k];
    f.by_rate[k] = rest > 0.0 ? axial.damping * slope : Lanes{};
    for (int l = 0; l < 3; ++l) {
      const Lanes slack = l == k ? pushed_slope : Lanes{};
      f.slope[k][l] = rest > 0.0 ? slack : f.slope[k][l];
    }
  }
  return f;
}

/// Sets the membrane tangent: material stiffness of the strains and geometric stiffness of their tangents.
inline void set_membrane_tangent(BatchTangent& tangent, const Batch& e, const Membrane& membrane,
                                 const StrainForces& f) {
  constexpr int kTurnBlock = kTurn - 1, kChordBlock = kChord - 1, kBothBlock = kBoth - 1;
  const Lanes(&force)[3] = f.force;
  Lanes stiffness[3][3];
  for (int k = 0; k < 3; ++k) {
    for (int l = 0; l < 3; ++l) stiffness[k][l] = e.inv_h * f.slope[k][l];
  }
  const Vec lower = 0.5 * membrane.u[0], chord = kMidChord * membrane.u[1], both = kMidBoth * membrane.u[1],
            upper = 0.5 * membrane.u[2];
  // Change of the strain tensions, sums over the points times the mass, with turn, chord and both.
  const auto by_turn = [&](int k) { return stiffness[k][2] * upper - stiffness[k][0] * lower; };
  const auto by_chord = [&](int k) { return stiffness[k][1] * chord; };
  const auto by_both = [&](int k) {
    return stiffness[k][0] * lower + stiffness[k][1] * both + stiffness[k][2] * upper;
  };
  const auto turning = [&](int k, double share) {
    const Lanes geometric = share * force[k] * membrane.inv_norm[k] * e.inv_h;
    return full(dyad(geometric, -geometric, membrane.u[k]));
  };
  const Mat first = turning(0, 0.25), mid = turning(1, 1.0), last = turning(2, 0.25);
  const Mat ends = first + last;
  set_slope_block(tangent, kTurnBlock, kTurnBlock, outer(upper, by_turn(2)) + outer(-1.0 * lower, by_turn(0)) + ends);
  set_slope_block(tangent, kTurnBlock, kChordBlock, outer(upper, by_chord(2)) + outer(-1.0 * lower, by_chord(0)));
  set_slope_block(tangent, kTurnBlock, kBothBlock,
                  outer(upper, by_both(2)) + outer(-1.0 * lower, by_both(0)) + last + -1.0 * first);
  set_slope_block(tangent, kChordBlock, kChordBlock, outer(chord, by_chord(1)) + (kMidChord * kMidChord) * mid);
  set_slope_block(tangent, kChordBlock, kBothBlock, outer(chord, by_both(1)) + (kMidChord * kMidBoth) * mid);
  set_slope_block(tangent, kBothBlock, kBothBlock,
                  outer(lower, by_both(0)) + outer(both, by_both(1)) + outer(upper, by_both(2)) + ends +
                      (kMidBoth * kMidBoth) * mid);
}

/// Sets the tangent from the rates of strains whose tangents rotate: unsymmetric. `join` adds it.
inline void set_rate_tangent(BatchTangent& tangent, const Batch& e, const Membrane& membrane, const StrainForces& f) {
  tangent.has_rates = true;
  for (int k = 0; k < 3; ++k) {
    tangent.rate_rows[k] = (e.inv_h * f.by_rate[k]) * membrane.u[k];
    tangent.rate_columns[k] = membrane.turning[k];
  }
}

/// Sets the tangent from the tension of pressure, which varies with the height of the strain points, mean -+ chord/2 at
/// the ends and mean - turn/8 in the middle: unsymmetric.
inline void set_pressure_tangent(BatchTangent& tangent, const Membrane& membrane) {
  for (int i = 0; i < 3; ++i) {
    Vec by_height[3];
    for (int k = 0; k < 3; ++k) {
      const Lanes lower = kStrainMass[k][0] * membrane.tension_slope[0],
                  mid = kStrainMass[k][1] * membrane.tension_slope[1],
                  upper = kStrainMass[k][2] * membrane.tension_slope[2];
      by_height[k] = (i == kMean   ? lower + mid + upper
                      : i == kTurn ? -0.125 * mid
                                   : 0.5 * (upper - lower)) *
                     membrane.u[k];
    }
    const Vec rows[3] = {0.5 * (by_height[2] - by_height[0]), kMidChord * by_height[1],
                         0.5 * (by_height[0] + by_height[2]) + kMidBoth * by_height[1]};
    for (int j = 0; j < 3; ++j) {
      tangent.by_height[3 * j][i] = rows[j].x;
      tangent.by_height[3 * j + 1][i] = rows[j].y;
      tangent.by_height[3 * j + 2][i] = rows[j].z;
    }
  }
}

/// Adds the membrane with the effective tension from pressure, which varies with depth. `tangent` is null unless
/// kTangent.
template <bool kTangent>
inline void add_membrane(Batch& e, BatchTangent* tangent, const AxialConstants& axial, const Membrane& membrane) {
  const bool slack = axial.slack();
  StrainForces f = slack ? forces_with_slack(membrane, axial) : linear_forces(membrane, axial.EA);
  add_pressure(f, membrane);
  // times h, over h
  e.by_tangent[0] = e.by_tangent[0] + f.force[0] * membrane.u[0];
  e.by_cubic[1] = e.by_cubic[1] + f.force[1] * membrane.u[1];
  e.by_tangent[1] = e.by_tangent[1] + f.force[2] * membrane.u[2];
  if constexpr (kTangent) {
    set_membrane_tangent(*tangent, e, membrane, f);
    if (slack) set_rate_tangent(*tangent, e, membrane, f);
    set_pressure_tangent(*tangent, membrane);
  }
}

}  // namespace
}  // namespace overbend::OVERBEND_ISA_NAMESPACE
