#include "recording/surface_crossing.h"

#include <algorithm>
#include <cmath>

#include "mechanics/line_kernel.h"

namespace overbend {
namespace {

/// Motion of a node relative to the surface.
struct SurfaceMotion {
  double rising = 0.0;  ///< Upward speed relative to the surface [m/s].
  double across = 0.0;  ///< Component of a vertical motion across the pipe [-].
};

SurfaceMotion over_surface(const LineState& state, const std::vector<double>& waves, std::size_t node) {
  const double* q = state.q.data() + 6 * node;
  const double upwards = waves.empty() ? 0.0 : waves[kWaterValues * node + 2];
  return {state.v[6 * node + 2] - upwards, std::hypot(q[3], q[4]) / std::hypot(q[3], q[4], q[5])};
}

double height_over_surface(const LineState& state, const std::vector<double>& waves, std::size_t node) {
  return state.q[6 * node + 2] - (waves.empty() ? 0.0 : waves[kWaterValues * node + 6]);
}

}  // namespace

void SurfaceCrossing::add(const LineState& state, double time, const std::vector<double>& water, const LineMesh& mesh,
                          double shift) {
  if (time <= 0.0) return;
  double low = height_over_surface(state, water, 0);
  for (std::size_t e = 0; e < mesh.length.size(); ++e) {
    const double high = height_over_surface(state, water, e + 1);
    if ((low < 0.0) != (high < 0.0)) {
      const SurfaceMotion below = over_surface(state, water, e), above = over_surface(state, water, e + 1);
      const double share = low / (low - high);
      const auto between = [&](double a, double b) { return a + share * (b - a); };
      const double speed = -between(below.rising, above.rising) * between(below.across, above.across);
      if (speed > speed_) {
        speed_ = speed;
        s_ = mesh.s[e] + share * mesh.length[e] + shift;
        time_ = time;
      }
    }
    low = high;
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
