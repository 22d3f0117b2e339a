#include "mechanics/roller_contact.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace overbend {
namespace {

using Vec3Map = Eigen::Map<const Vec3>;

/// Distance measured from `reference`, with or without the part along the roller's axis.
struct Projection {
  Vec3 reference;
  Vec3 axis;
  bool along_axis_counts;

  Vec3 apply(const Vec3& v) const { return along_axis_counts ? v : Vec3(v - v.dot(axis) * axis); }
};

/// The projected distance vector along an element as powers of xi: c0 + c1 xi + c2 xi^2 + c3 xi^3.
struct CubicVector {
  Vec3 c0, c1, c2, c3;
};

CubicVector distance_vector(const Projection& projection, const ElementVector& q, double h) {
  const Vec3 r1 = projection.apply(q.segment<3>(0) - projection.reference);
  const Vec3 chord = projection.apply(q.segment<3>(6) - q.segment<3>(0));
  const Vec3 t1 = h * projection.apply(q.segment<3>(3)), t2 = h * projection.apply(q.segment<3>(9));
  return {r1, t1, 3.0 * chord - 2.0 * t1 - t2, t1 + t2 - 2.0 * chord};
}

/// P(r - C) . r' of a distance vector as powers of xi, from f[0] on.
std::array<double, 6> along_powers(const CubicVector& c) {
  return {c.c0.dot(c.c1),
          c.c1.squaredNorm() + 2.0 * c.c0.dot(c.c2),
          3.0 * (c.c0.dot(c.c3) + c.c1.dot(c.c2)),
          4.0 * c.c1.dot(c.c3) + 2.0 * c.c2.squaredNorm(),
          5.0 * c.c2.dot(c.c3),
          3.0 * c.c3.squaredNorm()};
}

/// Solves P(r - C) . r' = 0 in [0, 1] by safeguarded Newton iteration from `xi`; the function changes sign over the
/// element.
double stationary_xi(const Projection& projection, const ElementVector& q, double h, double xi = 0.5) {
  constexpr double kClose = 1e-4;  // Newton iteration squares the remaining error
  const std::array<double, 6> f = along_powers(distance_vector(projection, q, h));
  double low = 0.0, high = 1.0;
  for (int iteration = 0; iteration < 60; ++iteration) {
    const double value = f[0] + xi * (f[1] + xi * (f[2] + xi * (f[3] + xi * (f[4] + xi * f[5]))));
    (value > 0.0 ? high : low) = xi;
    const double slope = f[1] + xi * (2.0 * f[2] + xi * (3.0 * f[3] + xi * (4.0 * f[4] + 5.0 * xi * f[5])));
    double next = slope > 0.0 ? xi - value / slope : -1.0;
    if (!(next >= low && next <= high)) {
      next = 0.5 * (low + high);
    } else if (std::abs(next - xi) < kClose) {
      return next;
    }
    if (high - low < 1e-15) {
      return next;
    }
    xi = next;
  }
  return xi;
}

ElementVector element_unknowns(const double* q, int element) {
  return ElementVector(Eigen::Map<const ElementVector>(q + 6 * element));
}

Vec3 place_at(const ElementVector& q, double xi, double h) {
  return Eigen::Map<const Eigen::Matrix<double, 3, 4>>(q.data()) * hermite(xi, h).value;
}

void find_place(ClosestPoint& closest, const double* q, const double* length) {
  const HermiteValues n = hermite(closest.xi, length[closest.element]);
  const Eigen::Map<const Eigen::Matrix<double, 3, 4>> nodes(q + 6 * closest.element);
  closest.place = nodes * n.value;
  closest.tangent = nodes * n.first;
}

/// Returns the closest of the local minima of the distance over all elements.
ClosestPoint search(const Projection& projection, const double* q, const double* length, int first, int last) {
  ClosestPoint best;
  double best_distance = 0.0;
  const auto along = [&](int node) {
    return projection.apply(Vec3Map(q + 6 * node) - projection.reference).dot(Vec3Map(q + 6 * node + 3));
  };
  double before = first < last ? along(first) : 0.0;
  for (int e = first; e < last; ++e) {
    const double after = along(e + 1);
    if (before < 0.0 && after >= 0.0) {
      const ElementVector dofs = element_unknowns(q, e);
      const double xi = stationary_xi(projection, dofs, length[e]);
      const double distance = projection.apply(place_at(dofs, xi, length[e]) - projection.reference).norm();
      if (!best.found || distance < best_distance) {
        best.found = true;
        best.element = e;
        best.xi = xi;
        best_distance = distance;
      }
    }
    before = after;
  }
  best.reference = projection.reference;
  return best;
}

/// Searches outwards from `element` until the distance stops decreasing.
ClosestPoint search_near(const Projection& projection, const double* q, const double* length, int first, int last,
                         int element, double xi) {
  const auto along = [&](int node) {
    return projection.apply(Vec3Map(q + 6 * node) - projection.reference).dot(Vec3Map(q + 6 * node + 3));
  };
  int e = std::clamp(element, first, last - 1);
  double before = along(e), after = along(e + 1);
  while (before >= 0.0 && e > first) {
    after = before;
    before = along(--e);
  }
  while (after < 0.0 && e + 1 < last) {
    before = after;
    after = along(++e + 1);
  }
  if (!(before < 0.0 && after >= 0.0)) {
    return search(projection, q, length, first, last);
  }
  ClosestPoint closest;
  closest.found = true;
  closest.element = e;
  closest.xi = stationary_xi(projection, element_unknowns(q, e), length[e], e == element ? xi : 0.5);
  closest.reference = projection.reference;
  return closest;
}

/// Switches to the end of the roller if the point lies beyond the face.
template <class Search>
ClosestPoint closest(const PlacedRoller& roller, const double* q, const double* length, const Search& find) {
  ClosestPoint closest = find(Projection{roller.center, roller.axis, false});
  if (!closest.found) {
    return closest;
  }
  closest.passing = closest.element;
  find_place(closest, q, length);
  const double eta = (closest.place - roller.center).dot(roller.axis);
  if (std::abs(eta) <= roller.half_face) {
    return closest;
  }
  const Vec3 end = roller.center + std::copysign(roller.half_face, eta) * roller.axis;
  ClosestPoint beyond = find(Projection{end, roller.axis, true});
  beyond.beyond_face = true;
  beyond.passing = closest.passing;
  beyond.off_end = std::abs(eta) - roller.half_face;
  if (beyond.found) find_place(beyond, q, length);
  return beyond;
}

}  // namespace

ClosestPoint closest_point(const PlacedRoller& roller, const double* q, const double* length, int first, int last) {
  return closest(roller, q, length,
                 [&](const Projection& projection) { return search(projection, q, length, first, last); });
}

ClosestPoint closest_point_near(const PlacedRoller& roller, const double* q, const double* length, int first, int last,
                                int element, double xi) {
  if (first >= last) {
    return {};
  }
  return closest(roller, q, length, [&](const Projection& projection) {
    return search_near(projection, q, length, first, last, element, xi);
  });
}

void find_closest_points(const RolledLine& line, std::span<const RollerSearch> looks,
                         std::span<RollerClosestPoint> meetings, Isa isa) {
  const int count = static_cast<int>(looks.size());
#if defined(OVERBEND_X86_KERNELS)
  if (isa == Isa::avx512) return isa_avx512::find_closest_points(line, looks.data(), count, meetings.data());
  if (isa == Isa::avx2) return isa_avx2::find_closest_points(line, looks.data(), count, meetings.data());
#endif
  (void)isa;
  isa_baseline::find_closest_points(line, looks.data(), count, meetings.data());
}

RollerDistance roller_distance(const PlacedRoller& roller, const ClosestPoint& closest) {
  const Projection projection{closest.reference, roller.axis, closest.beyond_face};
  const Vec3 e = projection.apply(closest.place - closest.reference);
  const Vec3 across = closest.beyond_face ? e : Vec3(roller.axis.cross(closest.tangent));
  const double side = closest.beyond_face || across.dot(roller.normal) >= 0.0 ? 1.0 : -1.0;
  RollerDistance d;
  d.direction = side * across.normalized();
  d.value = e.dot(d.direction);
  return d;
}

RollerDistanceDerivatives roller_distance_derivatives(const PlacedRoller& roller, const ClosestPoint& closest,
                                                      const RollerDistance& distance, const ElementVector& q,
                                                      double h) {
  const Projection projection{closest.reference, roller.axis, closest.beyond_face};
  const HermiteValues n = hermite(closest.xi, h);
  RollerDistanceDerivatives d;
  for (int j = 0; j < 4; ++j) {
    d.gradient.segment<3>(3 * j) = n.value(j) * distance.direction;
  }
  // If the pipe's axis nearly meets the roller's, the curvature of the distance is unbounded and meaningless.
  if (std::abs(distance.value) < 0.1 * roller.radius) {
    return d;
  }
  const CentrelinePoint point = centreline(q, closest.xi, h);
  const Vec3 e = projection.apply(point.r - closest.reference);
  const Vec3 pa = projection.apply(point.a);
  const Mat3 p =
      closest.beyond_face ? Mat3(Mat3::Identity()) : Mat3(Mat3::Identity() - roller.axis * roller.axis.transpose());
  ElementVector f_xi_q;  // derivative of the stationarity condition with the unknowns, per metre of s
  for (int j = 0; j < 4; ++j) {
    f_xi_q.segment<3>(3 * j) = n.value(j) * pa + n.first(j) * e;
  }
  const double f_xi_xi = point.a.dot(pa) + e.dot(point.b);
  d.place = -f_xi_q / f_xi_xi;
  d.hessian.noalias() = -f_xi_q * f_xi_q.transpose() / (f_xi_xi * distance.value);
  d.hessian.noalias() -= d.gradient * d.gradient.transpose() / distance.value;
  for (int j = 0; j < 4; ++j) {
    for (int k = 0; k < 4; ++k) {
      d.hessian.block<3, 3>(3 * j, 3 * k) += (n.value(j) * n.value(k) / distance.value) * p;
    }
  }
  return d;
}

}  // namespace overbend
