/// A hull that floats free in still water, linear, for tests of its radiation alone.
#pragma once

#include <Eigen/LU>
#include <vector>

#include "hull/radiation.h"

namespace overbend::testing {

struct LinearHull {
  Mat6 mass = Mat6::Zero();  ///< Mass of the body alone.
  Mat6 stiffness = Mat6::Zero();
  Mat6 damping = Mat6::Zero();  ///< Damping in addition to radiation.
};

/// Mass and radii of gyration of data/bgl1, and the stiffness of its file.
inline LinearHull bgl1_hull(const HydrodynamicData& data) {
  LinearHull hull;
  hull.mass.diagonal() << 1.0, 1.0, 1.0, 10.5 * 10.5, 30.0 * 30.0, 30.0 * 30.0;
  hull.mass *= 19121.58e3;
  hull.stiffness = data.hydrostatic_stiffness;
  return hull;
}

/// Motions at the ends of the steps, the start first; trapezoidal rule, velocities linear in the step. `force(t)` acts
/// in addition.
template <typename Force>
std::vector<Vec6> simulate(const LinearHull& hull, const RadiationModel& radiation, const Vec6& start,
                           const std::vector<double>& steps, Force force) {
  std::vector<Vec6> motion = {start};
  RadiationMemory memory = make_bending_memory(radiation);
  Vec6 x = start, v = Vec6::Zero();
  const Mat6 mass = hull.mass + radiation.added_mass;
  double time = 0.0;
  for (const double h : steps) {
    const Vec6 before = force(time) - hull.stiffness * x - hull.damping * v - radiation_force(radiation, memory, v);
    const RadiationStep next = radiation_step(radiation, memory, v, h);
    // M (v1 - v0)/h = (f0 + f1)/2 with f1 = F1 - C (x0 + h (v0 + v1)/2) - B v1 - mu1
    const Mat6 left = mass / h + 0.5 * (next.slope + hull.damping + 0.5 * h * hull.stiffness);
    const Vec6 behind = force(time + h) - next.force_at_rest_end - hull.stiffness * (x + 0.5 * h * v);
    const Vec6 v1 = left.partialPivLu().solve(mass * v / h + 0.5 * (before + behind));
    advance(radiation, memory, v, v1, h);
    x += 0.5 * h * (v + v1);
    v = v1;
    time += h;
    motion.push_back(x);
  }
  return motion;
}

/// Motions from a release at rest at `start`, at i * step.
inline std::vector<Vec6> decay(const LinearHull& hull, const RadiationModel& radiation, const Vec6& start, double step,
                               std::size_t steps) {
  return simulate(hull, radiation, start, std::vector<double>(steps, step), [](double) { return Vec6(Vec6::Zero()); });
}

/// Time and value of the k-th extremum after the release of one freedom, by a parabola through three points.
struct Extremum {
  double time, value;
};
inline std::vector<Extremum> extrema(const std::vector<Vec6>& motion, int freedom, double step) {
  std::vector<Extremum> found;
  for (std::size_t i = 1; i + 1 < motion.size(); ++i) {
    const double a = motion[i - 1](freedom), b = motion[i](freedom), c = motion[i + 1](freedom);
    if ((b - a) * (c - b) <= 0.0 && a != b) {
      const double shift = 0.5 * (a - c) / (a - 2.0 * b + c);
      found.push_back({(static_cast<double>(i) + shift) * step, b - 0.25 * (a - c) * shift});
    }
  }
  return found;
}

}  // namespace overbend::testing
