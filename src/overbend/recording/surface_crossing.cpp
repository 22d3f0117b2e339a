#include "recording/surface_crossing.h"

#include <algorithm>
#include <cmath>

#include "mechanics/line_kernel.h"

namespace overbend {
namespace {

/// A node over the surface: height, speed upwards away from it, and how much of a vertical motion is across the pipe.
struct OverSurface {
  double height = 0.0, rising = 0.0, across = 0.0;
};

OverSurface over_surface(const LineState& state, const std::vector<double>& waves, std::size_t node) {
  const double* q = state.q.data() + 6 * node;
  const double* water = waves.empty() ? nullptr : waves.data() + kWaterValues * node;
  const double elevation = water != nullptr ? water[6] : 0.0, upwards = water != nullptr ? water[2] : 0.0;
  const double slope = std::hypot(q[3], q[4]) / std::hypot(q[3], q[4], q[5]);
  return {q[2] - elevation, state.v[6 * node + 2] - upwards, slope};
}

}  // namespace

void SurfaceCrossing::add(const LineState& state, double time, const std::vector<double>& water, const LineMesh& mesh,
                          double shift) {
  if (time <= 0.0) return;
  OverSurface below = over_surface(state, water, 0);
  for (std::size_t e = 0; e < mesh.length.size(); ++e) {
    const OverSurface above = over_surface(state, water, e + 1);
    if ((below.height < 0.0) != (above.height < 0.0)) {
      const double share = below.height / (below.height - above.height);
      const auto between = [&](double a, double b) { return a + share * (b - a); };
      const double speed = -between(below.rising, above.rising) * between(below.across, above.across);
      if (speed > speed_) {
        speed_ = speed;
        s_ = mesh.s[e] + share * mesh.length[e] + shift;
        time_ = time;
      }
    }
    below = above;
  }
}

void SurfaceCrossing::restore(const std::vector<double>& saved) {
  speed_ = saved.at(0);
  s_ = saved.at(1);
  time_ = saved.at(2);
}

double slamming_force(double density, double diameter, double speed) {
  constexpr double kFirstTouch = 5.15;
  return 0.5 * density * kFirstTouch * diameter * speed * speed;
}

}  // namespace overbend
