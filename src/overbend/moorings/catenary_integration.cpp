#include "moorings/catenary_integration.h"

#include <algorithm>
#include <cmath>

namespace overbend {
namespace {

/// Height of the line over which the bed takes up a clump weight on a tether; keeps the force continuous [m].
constexpr double kSetDownHeight = 0.02;

/// Returns t + v without cancellation for a tension t with horizontal part h and vertical part v.
Dual tension_and_sink(const Dual& pull, const Dual& sink, const Dual& tension) {
  return sink.v >= 0.0 ? tension + sink : pull * pull / (tension - sink);
}

/// Wetted share of the volume of a body of a given height with its centre at z, and its derivative.
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

void advance_catenary(CatenaryState& state, const Dual& length, double weight, double EA) {
  const Dual end = state.sink - weight * length;
  const Dual t0 = sqrt(state.pull * state.pull + state.sink * state.sink);
  const Dual t1 = sqrt(state.pull * state.pull + end * end);
  const Dual u0 = tension_and_sink(state.pull, state.sink, t0), u1 = tension_and_sink(state.pull, end, t1);
  // (asinh(V0/H) - asinh(V1/H)) / w, in a form that is valid for w = 0 as well.
  const Dual q = length * (u0 + u1) / ((t0 + t1) * u1);
  const Dual reach = std::abs(weight * q.v) < 1e-12 ? q : log1p(weight * q) / weight;
  state.x = state.x + state.pull * (reach + length / EA);
  state.z = state.z - length * (state.sink + end) * (1.0 / (t0 + t1) + 0.5 / EA);
  state.sink = end;
}

double length_to_level(const CatenaryState& state, double rise, double weight, double EA, double limit) {
  const double h = state.pull.v, v = state.sink.v;
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
  const double first_root = (v - v1) / weight, second_root = (v + v1) / weight;
  const double min_length = 1e-12 * limit;
  double length = 0.0;
  for (const double candidate : {std::min(first_root, second_root), std::max(first_root, second_root)}) {
    if (length == 0.0 && candidate > min_length && candidate <= limit) length = candidate;
  }
  return length;
}

CatenaryStretch next_stretch(const CatenaryState& state, const Dual& length, const CatenaryPiece& piece) {
  const double weight = state.above ? piece.weight_in_air : piece.weight_submerged;
  CatenaryStretch stretch{length, weight, false};
  if (piece.weight_in_air == piece.weight_submerged) return stretch;
  // A heavy line that is under water and descends to its end stays under water.
  if (!state.above && weight >= 0.0 && state.sink.v - weight * length.v >= 0.0) return stretch;
  const double to_surface = length_to_level(state, -state.z.v, weight, piece.EA, length.v);
  if (to_surface == 0.0) return stretch;
  CatenaryState end_state = state;
  Dual reached(to_surface);
  for (int i = 0; i < 2; ++i) {  // Newton with derivatives: exact in value and slope
    end_state = state;
    advance_catenary(end_state, reached, weight, piece.EA);
    const double tension = std::hypot(end_state.pull.v, end_state.sink.v);
    const double slope = -end_state.sink.v * (1.0 / tension + 1.0 / piece.EA);
    if (slope == 0.0) return stretch;
    reached = Dual(reached.v - end_state.z.v / slope, reached.d - end_state.z.d / slope);
  }
  if (reached.v >= length.v || reached.v <= 0.0) return stretch;
  return {reached, weight, true};
}

Dual pull_up(const CatenaryPoint& point, const Dual& z, const Dual& bed) {
  if (point.is_suspended_below()) {
    const Dual over = z - bed - point.tether;
    if (over.v <= 0.0) return 0.0;
    return over.v < kSetDownHeight ? (point.pull_up / kSetDownHeight) * over : Dual(point.pull_up);
  }
  if (point.buoyancy <= 0.0) return point.pull_up;
  const WettedShare wet = wetted_share(point.shape, z.v + point.tether, point.height);
  return Dual(point.pull_up - point.buoyancy * (1.0 - wet.share), point.buoyancy * wet.slope * z.d);
}

}  // namespace overbend
