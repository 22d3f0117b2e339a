#include "moorings/catenary_walk.h"

#include <algorithm>
#include <cmath>

namespace overbend {
namespace {

/// A clump on a tether is set down on the bed over this height of its line: the pull has to be steady [m].
constexpr double kSetDown = 0.02;

/// Of a tension t with horizontal part h and vertical part v: t + v, without cancellation.
Dual tension_and_sink(const Dual& pull, const Dual& sink, const Dual& tension) {
  return sink.v >= 0.0 ? tension + sink : pull * pull / (tension - sink);
}

/// Wetted share of the volume with its middle at z, and its derivative, of a body of that height.
struct WettedShare {
  double share = 1.0, slope = 0.0;
};
WettedShare wetted_share(BuoyShape shape, double z, double height) {
  if (height <= 0.0) return {z <= 0.0 ? 1.0 : 0.0, 0.0};
  const double under = std::clamp(0.5 - z / height, 0.0, 1.0);  // of the height
  const bool pierces = under > 0.0 && under < 1.0;
  if (shape == BuoyShape::cylinder) return {under, pierces ? -1.0 / height : 0.0};
  // Cap of a sphere: (3 u^2 - 2 u^3) of the volume for the share u of the diameter.
  return {under * under * (3.0 - 2.0 * under), pierces ? -6.0 * under * (1.0 - under) / height : 0.0};
}

}  // namespace

void hang(CatenaryState& at, const Dual& length, double weight, double EA) {
  const Dual end = at.sink - weight * length;
  const Dual t0 = sqrt(at.pull * at.pull + at.sink * at.sink);
  const Dual t1 = sqrt(at.pull * at.pull + end * end);
  const Dual u0 = tension_and_sink(at.pull, at.sink, t0), u1 = tension_and_sink(at.pull, end, t1);
  // asinh(V0/H) - asinh(V1/H) over w, in a form that holds for w = 0 as well.
  const Dual q = length * (u0 + u1) / ((t0 + t1) * u1);
  const Dual reach = std::abs(weight * q.v) < 1e-12 ? q : log1p(weight * q) / weight;
  at.x = at.x + at.pull * (reach + length / EA);
  at.z = at.z - length * (at.sink + end) * (1.0 / (t0 + t1) + 0.5 / EA);
  at.sink = end;
}

double length_to_level(const CatenaryState& at, double rise, double weight, double EA, double limit) {
  const double h = at.pull.v, v = at.sink.v;
  if (weight == 0.0) {
    const double slope = v * (1.0 / std::hypot(h, v) + 1.0 / EA);
    const double length = slope == 0.0 ? 0.0 : -rise / slope;
    return length > 0.0 && length <= limit ? length : 0.0;
  }
  // Tension and height along a hanging line: t + t^2/(2 EA) - w z is constant.
  const double t0 = std::hypot(h, v);
  const double energy = t0 + 0.5 * t0 * t0 / EA + weight * rise;
  const double t1 = 2.0 * energy / (1.0 + std::sqrt(std::max(1.0 + 2.0 * energy / EA, 0.0)));
  if (energy <= 0.0 || t1 < h) return 0.0;
  const double v1 = std::sqrt(std::max(t1 * t1 - h * h, 0.0));
  const double one = (v - v1) / weight, other = (v + v1) / weight;
  const double least = 1e-12 * limit;
  double length = 0.0;
  for (const double candidate : {std::min(one, other), std::max(one, other)}) {
    if (length == 0.0 && candidate > least && candidate <= limit) length = candidate;
  }
  return length;
}

CatenaryStretch next_stretch(const CatenaryState& at, const Dual& length, const CatenaryPiece& piece) {
  const double weight = at.above ? piece.weight_in_air : piece.weight_submerged;
  CatenaryStretch stretch{length, weight, false};
  if (piece.weight_in_air == piece.weight_submerged) return stretch;
  // Under water and going down to where it ends, a heavy line stays there.
  if (!at.above && weight >= 0.0 && at.sink.v - weight * length.v >= 0.0) return stretch;
  const double to_surface = length_to_level(at, -at.z.v, weight, piece.EA, length.v);
  if (to_surface == 0.0) return stretch;
  CatenaryState there = at;
  Dual reached(to_surface);
  for (int i = 0; i < 2; ++i) {  // Newton with derivatives: exact in value and slope
    there = at;
    hang(there, reached, weight, piece.EA);
    const double tension = std::hypot(there.pull.v, there.sink.v);
    const double slope = -there.sink.v * (1.0 / tension + 1.0 / piece.EA);
    if (slope == 0.0) return stretch;
    reached = Dual(reached.v - there.z.v / slope, reached.d - there.z.d / slope);
  }
  if (reached.v >= length.v || reached.v <= 0.0) return stretch;
  return {reached, weight, true};
}

Dual pull_up(const CatenaryPoint& point, const Dual& z, const Dual& bed) {
  if (point.hangs_under()) {
    const Dual over = z - bed - point.tether;
    if (over.v <= 0.0) return 0.0;
    return over.v < kSetDown ? (point.pull_up / kSetDown) * over : Dual(point.pull_up);
  }
  if (point.buoyancy <= 0.0) return point.pull_up;
  const WettedShare wet = wetted_share(point.shape, z.v + point.tether, point.height);
  return Dual(point.pull_up - point.buoyancy * (1.0 - wet.share), point.buoyancy * wet.slope * z.d);
}

}  // namespace overbend
