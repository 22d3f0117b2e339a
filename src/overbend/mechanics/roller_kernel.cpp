#include "mechanics/roller_kernel.h"

#include "mechanics/lane_vectors.h"

namespace overbend::OVERBEND_ISA_NAMESPACE {
namespace {

constexpr int kDofs = 12;  ///< Unknowns of an element: r1, t1, r2, t2.

/// Mask of lanes: true (all bits) or false.
using LaneMask = decltype(Lanes{} < Lanes{});

/// Rollers with the elements of their looks.
struct Batch {
  const RollerSearch* looks[kWidth];
  int element[kWidth];
  Vec center, axis, normal;
  Lanes half_face, xi, h;
  Vec q[4], v[4];
};

/// Reference of the distance, see Projection of roller_contact.cpp: `across` is 1 if the component along the axis is
/// removed, else 0.
struct Projection {
  Vec reference, axis;
  Lanes across;

  Vec apply(const Vec& v) const { return v - (across * dot(v, axis)) * axis; }
};

struct Point {
  LaneMask found;
  Lanes xi;
};

inline bool any(const LaneMask& truth) {
  long long found = 0;
  for (int l = 0; l < kWidth; ++l) {
    found |= truth[l];
  }
  return found != 0;
}

inline Lanes magnitude(const Lanes& x) {
  return x < 0.0 ? -x : x;
}

inline Vec chosen(const LaneMask& first, const Vec& a, const Vec& b) {
  return {first ? a.x : b.x, first ? a.y : b.y, first ? a.z : b.z};
}

/// Gathers the values of the elements' nodes, lane by lane.
void gather(const double* values, const int (&element)[kWidth], Vec (&out)[4]) {
  Lanes parts[kDofs];
  for (int from = 0; from < kDofs; from += kWidth) {
    const int start = from + kWidth <= kDofs ? from : kDofs - kWidth;  // the last part ends with the element
    Lanes rows[kWidth];
    for (int l = 0; l < kWidth; ++l) {
      rows[l] = unaligned(values + 6 * element[l] + start);
    }
    transpose(rows);
    for (int j = 0; j < kWidth; ++j) {
      parts[start + j] = rows[j];
    }
  }
  for (int node = 0; node < 4; ++node) {
    out[node] = {parts[3 * node], parts[3 * node + 1], parts[3 * node + 2]};
  }
}

void put_vector(Vec& out, int lane, const double* from) {
  out.x[lane] = from[0];
  out.y[lane] = from[1];
  out.z[lane] = from[2];
}

/// Gathers the elements named in the batch.
void gather_elements(const RolledLine& line, Batch& batch) {
  for (int l = 0; l < kWidth; ++l) {
    batch.h[l] = line.length[batch.element[l]];
  }
  gather(line.q, batch.element, batch.q);
  gather(line.v, batch.element, batch.v);
}

/// Gathers rollers from `first` on, with the elements that pass them; the last one fills the rest of the register.
void gather(const RolledLine& line, const RollerSearch* looks, int first, int count, Batch& batch) {
  for (int l = 0; l < kWidth; ++l) {
    const RollerSearch& look = looks[first + l < count ? first + l : count - 1];
    batch.looks[l] = &look;
    batch.element[l] = look.passing;
    put_vector(batch.center, l, look.center);
    put_vector(batch.axis, l, look.axis);
    put_vector(batch.normal, l, look.normal);
    batch.half_face[l] = look.half_face;
    batch.xi[l] = look.passing == look.element ? look.xi : 0.5;
  }
  gather_elements(line, batch);
}

/// Gathers the roller ends for lanes beyond the face, with the elements of their previous closest points.
void gather_ends(const RolledLine& line, const LaneMask& ends, Batch& batch) {
  for (int l = 0; l < kWidth; ++l) {
    if (!ends[l]) continue;
    batch.element[l] = batch.looks[l]->element;
    batch.xi[l] = batch.looks[l]->xi;
  }
  gather_elements(line, batch);
}

/// Returns xi with P(r - C) . r' = 0: safeguarded Newton iteration, as in roller_contact.cpp.
Lanes stationary_xi(const Lanes (&f)[6], Lanes xi, LaneMask open) {
  constexpr double kClose = 1e-4;
  Lanes low{}, high = all(1.0);
  for (int iteration = 0; iteration < 60 && any(open); ++iteration) {
    const Lanes value = f[0] + xi * (f[1] + xi * (f[2] + xi * (f[3] + xi * (f[4] + xi * f[5]))));
    const Lanes slope = f[1] + xi * (2.0 * f[2] + xi * (3.0 * f[3] + xi * (4.0 * f[4] + 5.0 * xi * f[5])));
    const LaneMask above = value > 0.0;
    high = above ? xi : high;
    low = above ? low : xi;
    const Lanes by_slope = xi - value / slope;
    const LaneMask good = (slope > 0.0) & (by_slope >= low) & (by_slope <= high);
    const Lanes next = good ? by_slope : 0.5 * (low + high);
    const LaneMask close = (good & (magnitude(next - xi) < kClose)) | (high - low < 1e-15);
    xi = open ? next : xi;
    open &= ~close;
  }
  return xi;
}

Point closest(const Batch& batch, const Projection& projection) {
  const Vec from1 = projection.apply(batch.q[0] - projection.reference);
  const Vec from2 = projection.apply(batch.q[2] - projection.reference);
  const LaneMask found = (dot(from1, batch.q[1]) < 0.0) & (dot(from2, batch.q[3]) >= 0.0);
  // Distance as powers of xi, and half the derivative of its square.
  const Vec& c0 = from1;
  const Vec c1 = batch.h * projection.apply(batch.q[1]), last = batch.h * projection.apply(batch.q[3]);
  const Vec chord = from2 - from1;
  const Vec c2 = 3.0 * chord - 2.0 * c1 - last, c3 = c1 + last - 2.0 * chord;
  const Lanes f[6] = {dot(c0, c1),
                      dot(c1, c1) + 2.0 * dot(c0, c2),
                      3.0 * (dot(c0, c3) + dot(c1, c2)),
                      4.0 * dot(c1, c3) + 2.0 * dot(c2, c2),
                      5.0 * dot(c2, c3),
                      3.0 * dot(c3, c3)};
  return {found, stationary_xi(f, batch.xi, found)};
}

/// Shape functions of the element at xi, or their derivatives with the unstressed length.
struct Shape {
  Lanes n[4];

  Vec of(const Vec (&nodes)[4]) const { return n[0] * nodes[0] + n[1] * nodes[1] + n[2] * nodes[2] + n[3] * nodes[3]; }
};

Shape values_at(const Lanes& x, const Lanes& h) {
  const Lanes x2 = x * x, x3 = x2 * x;
  return {{1.0 - 3.0 * x2 + 2.0 * x3, h * (x - 2.0 * x2 + x3), 3.0 * x2 - 2.0 * x3, h * (x3 - x2)}};
}

Shape slopes_at(const Lanes& x, const Lanes& h) {
  const Lanes x2 = x * x, up = (6.0 * x - 6.0 * x2) / h;
  return {{-up, 1.0 - 4.0 * x + 3.0 * x2, up, 3.0 * x2 - 2.0 * x}};
}

void take_vector(const Vec& from, int lane, double* out) {
  out[0] = from.x[lane];
  out[1] = from.y[lane];
  out[2] = from.z[lane];
}

void meet(const RolledLine& line, Batch& batch, RollerClosestPoint* meetings, int count) {
  Projection projection{batch.center, batch.axis, all(1.0)};
  Point point = closest(batch, projection);
  Shape shape = values_at(point.xi, batch.h);
  Vec place = shape.of(batch.q);
  const Lanes eta = dot(place - batch.center, batch.axis);
  const Lanes off_end = magnitude(eta) - batch.half_face;
  const LaneMask beyond = off_end > 0.0;
  if (any(beyond & point.found)) {  // continue at the end of the roller
    const Vec end = batch.center + (eta < 0.0 ? -batch.half_face : batch.half_face) * batch.axis;
    projection = {chosen(beyond, end, batch.center), batch.axis, beyond ? Lanes{} : all(1.0)};
    gather_ends(line, beyond, batch);
    const Point closest_point = closest(batch, projection);
    point.found &= closest_point.found | ~beyond;
    point.xi = beyond ? closest_point.xi : point.xi;
    shape = values_at(point.xi, batch.h);
    place = shape.of(batch.q);
  }
  const Vec tangent = slopes_at(point.xi, batch.h).of(batch.q), velocity = shape.of(batch.v);
  const Vec distance = projection.apply(place - projection.reference);
  const Vec across = chosen(beyond, distance, cross(batch.axis, tangent));
  const LaneMask on_side = beyond | (dot(across, batch.normal) >= 0.0);
  const Vec direction = ((on_side ? all(1.0) : all(-1.0)) / root(dot(across, across))) * across;
  const Lanes value = dot(distance, direction);
  for (int l = 0; l < count; ++l) {
    RollerClosestPoint& out = meetings[l];
    out.found = point.found[l] != 0;
    out.beyond_face = beyond[l] != 0;
    out.element = batch.element[l];
    out.passing = batch.looks[l]->passing;
    out.xi = point.xi[l];
    out.off_end = out.beyond_face ? off_end[l] : 0.0;
    out.distance = value[l];
    take_vector(place, l, out.place);
    take_vector(tangent, l, out.tangent);
    take_vector(velocity, l, out.velocity);
    take_vector(projection.reference, l, out.reference);
    take_vector(direction, l, out.direction);
    for (int j = 0; j < 4; ++j) {
      out.shape[j] = shape.n[j][l];
    }
  }
}

}  // namespace

void find_closest_points(const RolledLine& line, const RollerSearch* looks, int count, RollerClosestPoint* meetings) {
  for (int first = 0; first < count; first += kWidth) {
    Batch batch;
    gather(line, looks, first, count, batch);
    const int left = count - first;
    meet(line, batch, meetings + first, left < kWidth ? left : kWidth);
  }
}

}  // namespace overbend::OVERBEND_ISA_NAMESPACE
