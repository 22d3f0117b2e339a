/// Sections of a batch with plastic strain but no current slip, with their exact derivatives. For line_kernel.cpp only.
/// Formulas and slipping sections: mechanics/plastic_bending.h.
#pragma once

#include "mechanics/line_kernel_strain.h"

namespace overbend::OVERBEND_ISA_NAMESPACE {
namespace {

/// u v' + v u'
inline void add_both_dyads(Mat& m, const Vec& u, const Vec& v) {
  const Lanes uc[3] = {u.x, u.y, u.z}, vc[3] = {v.x, v.y, v.z};
  for (int r = 0; r < 3; ++r) {
    for (int c = 0; c < 3; ++c) {
      m.m[r][c] += uc[r] * vc[c] + vc[r] * uc[c];
    }
  }
}

/// Subtracts a plastic moment from the elastic one at Gauss point i: the moment M rotates with the tangent as its axes
/// do, and is conjugate to the curvature (b - (a.b)/g a)/|a| with g = a.a.
template <bool kTangent>
inline void subtract_plastic_moment(Batch& e, BatchTangent* tangent, int i, const PointSlope& slope, const Vec& M) {
  const Vec &a = slope.a, &b = slope.b;
  const Lanes ig = slope.inv_g, g1 = slope.inv_norm, g3 = g1 * ig, m = dot(a, b), beta = dot(M, b);
  const double w = kGauss[i].weight;  // times h, one h cancels in each derivative
  add_strain_force(e, kGauss[i], w * ((beta * g3) * a + (m * g3) * M), (-w * e.inv_h * g1) * M);
  if constexpr (kTangent) {
    const Lanes wa = w * e.inv_h, wm = wa * e.inv_h;
    const Vec k = g1 * (b - (m * ig) * a);
    const Vec u = (g3 * wa) * b - (0.5 * wa * ig) * k - (3.0 * wa * m * g3 * ig) * a;
    add_both_dyads(tangent->aa[i], u, M);
    add_sym(tangent->aa[i], wa, dyad(beta * g3, -3.0 * beta * g3 * ig, a));
    add_both_dyads(tangent->ba[i], (wm * g3) * a, M);
  }
}

/// Adds the held plastic moments at all Gauss points; `counts` are the lengths of the elements, 0 for padding elements.
template <bool kTangent>
inline void add_held_sections(Batch& e, BatchTangent* tangent, const PointSlope (&slopes)[kGaussPoints],
                              const HeldSections& held, const Lanes& counts, int first, int padded) {
  Lanes stored = load_lanes(held.stored);
#pragma GCC unroll 1
  for (int i = 0; i < kGaussPoints; ++i) {
    const PointSlope& slope = slopes[i];
    const double* values = held.values + kHeldValues * i * padded + first;
    const auto value = [&](int number) { return load_lanes(values + number * padded); };
    const auto vector = [&](int number) { return Vec{value(number), value(number + 1), value(number + 2)}; };
    const Vec t = slope.inv_norm * slope.a, before = vector(kHeldTangent), was = vector(kHeldAxis);
    const Vec axis = was - (dot(was, t) / (1.0 + dot(before, t))) * (before + t), second_axis = cross(t, axis);
    const Lanes kx = slope.inv_norm * dot(slope.b, axis), ky = slope.inv_norm * dot(slope.b, second_axis);
    const Lanes dx = kx - value(kHeldCenter), dy = ky - value(kHeldCenter + 1);
    const Lanes slack = value(kHeldSlack), within = slack > 0.0 ? slack * slack : -slack * slack;
    const Lanes left = dx * dx + dy * dy > within ? all(1.0) : Lanes{};
    *reinterpret_cast<Lanes*>(held.left + i * padded + first) = left;
    double* after = held.after + kHeldValues * i * padded + first;
    const Lanes carried[6] = {t.x, t.y, t.z, axis.x, axis.y, axis.z};  // kHeldTangent and kHeldAxis
    for (int number = 0; number < 6; ++number) {
      *reinterpret_cast<Lanes*>(after + number * padded) = carried[number];
    }
    const Lanes held_share = 1.0 - left;
    const Lanes mx = held_share * value(kHeldMoment), my = held_share * value(kHeldMoment + 1);
    stored += (kGauss[i].weight * counts) * (held_share * value(kHeldStored) - kx * mx - ky * my);
    if (!any(mx * mx + my * my)) continue;
    subtract_plastic_moment<kTangent>(e, tangent, i, slope, mx * axis + my * second_axis);
  }
  *reinterpret_cast<Lanes*>(held.stored) = stored;
}

}  // namespace
}  // namespace overbend::OVERBEND_ISA_NAMESPACE
