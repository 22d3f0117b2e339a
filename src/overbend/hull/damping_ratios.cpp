#include "hull/damping_ratios.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

#include "hull/make_radiation.h"
#include "model/waves/rao_table.h"

namespace overbend {
namespace {

/// Damping component of the force on the low-frequency motion: the filter delays position and rate alike.
double damping_by_slow_motion(double stiffness, double damping, double omega, double low_frequency_period) {
  const std::complex<double> s(0.0, omega);
  const double w = 2.0 * std::numbers::pi / low_frequency_period;
  const std::complex<double> filter = w * w / ((s + w) * (s + w));
  return (filter * (stiffness + damping * s)).imag() / omega;
}

/// Oscillation of a mode with dynamic positioning and the added mass of its own frequency, initially `omega` [rad/s];
/// `damping` acts on the hull's total velocity.
DampedOscillation positioned_swing(const HydrodynamicData& data, int freedom, double mass, double omega,
                                   SlowLoop loop) {
  constexpr int kTimes = 5;  // added mass hardly changes at long periods
  DampedOscillation found;
  for (int i = 0; i < kTimes; ++i) {
    loop.mass = mass + added_mass_at(data, omega)(freedom, freedom);
    found = find_least_damped(loop);
    if (!(found.period > 0.0)) break;
    omega = 2.0 * std::numbers::pi / found.period;
  }
  return found;
}

}  // namespace

DampedOscillation find_least_damped(const SlowLoop& loop) {
  // In z = s/w: (z^2 + a z + b) (z + 1)^2 + d + f z.
  const double w = 2.0 * std::numbers::pi / loop.low_frequency_period;
  const double a = loop.damping / (loop.mass * w), b = loop.stiffness / (loop.mass * w * w);
  const double f = loop.slow_damping / (loop.mass * w), d = loop.slow_stiffness / (loop.mass * w * w);
  Eigen::Matrix4d companion = Eigen::Matrix4d::Zero();
  companion.diagonal(-1).setOnes();
  companion.col(3) << -(b + d), -(a + 2.0 * b + f), -(1.0 + 2.0 * a + b), -(2.0 + a);
  const Eigen::EigenSolver<Eigen::Matrix4d> roots(companion, false);
  DampedOscillation result{0.0, 1.0};
  for (const std::complex<double>& z : roots.eigenvalues()) {
    const double damping = -z.real() / std::abs(z);
    if (z.imag() > 0.0 && damping < result.damping) result = {2.0 * std::numbers::pi / (w * z.imag()), damping};
  }
  return result;
}

Mat6 added_mass_at(const HydrodynamicData& data, double omega) {
  const std::vector<RadiationPoint>& points = data.radiation;
  if (points.empty()) return data.added_mass_infinite;
  const auto after = std::upper_bound(points.begin(), points.end(), omega,
                                      [](double w, const RadiationPoint& point) { return w < point.omega; });
  if (after == points.begin()) return points.front().added_mass;
  if (after == points.end()) return points.back().added_mass;
  const RadiationPoint &low = *(after - 1), &high = *after;
  const double share = (omega - low.omega) / (high.omega - low.omega);
  return (1.0 - share) * low.added_mass + share * high.added_mass;
}

double natural_frequency(const HydrodynamicData& data, int mode, double mass, double stiffness) {
  // w^2 (m + A(w)) - c is negative at 0 and positive at the natural frequency without added mass.
  double low = 0.0, high = std::sqrt(stiffness / mass);
  for (int i = 0; i < 60; ++i) {
    const double middle = 0.5 * (low + high);
    const bool stiff = middle * middle * (mass + added_mass_at(data, middle)(mode, mode)) < stiffness;
    (stiff ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

double critical_damping(const HydrodynamicData& data, int mode, double mass, double stiffness) {
  return 2.0 * stiffness / natural_frequency(data, mode, mass, stiffness);
}

std::array<ModeDamping, 3> horizontal_damping(const Hull& hull, const HydrodynamicData& data,
                                              const Mat6& station_stiffness) {
  const CurrentForce current = current_force(hull.current, hull.lies(5), Vec6::Zero(), StripWater{});
  std::array<ModeDamping, 3> modes;
  const std::array<int, 3> freedoms = {0, 1, 5};
  for (std::size_t i = 0; i < 3; ++i) {
    const int k = freedoms[i];
    ModeDamping& mode = modes[i];
    mode.mode = kFreedomNames[static_cast<std::size_t>(k)];
    const auto place = static_cast<Eigen::Index>(i);
    const double by_station = hull.station_keeping ? hull.station_keeping->law.stiffness(place) : 0.0;
    const double stiffness = station_stiffness(k, k) + by_station;
    if (!(stiffness > 0.0)) continue;
    const double mass = k < 3 ? hull.body.mass : hull.body.inertia(2, 2);
    const double omega = natural_frequency(data, k, mass, stiffness);
    mode.period = 2.0 * std::numbers::pi / omega;
    mode.critical = 2.0 * stiffness / omega;
    mode.radiation = radiation_at(hull.radiation, omega).damping(k, k) / mode.critical;
    mode.drift = hull.drift_damping(k, k) / mode.critical;
    const double by_current = -current.by_v(k, k);
    const bool slow = hull.current.form == HullCurrentModel::table;
    mode.current =
        (slow ? damping_by_slow_motion(0.0, by_current, omega, hull.low_frequency_period) : by_current) / mode.critical;
    mode.viscous = hull.damping.linear(k, k) / mode.critical;
    if (hull.station_keeping) {
      const double damping = hull.station_keeping->law.damping(place);
      mode.station_keeping =
          damping_by_slow_motion(by_station, damping, omega, hull.low_frequency_period) / mode.critical;
      SlowLoop loop;
      loop.damping = mode.critical * (mode.radiation + mode.drift + mode.viscous) + (slow ? 0.0 : by_current);
      loop.stiffness = station_stiffness(k, k);
      loop.slow_damping = damping + (slow ? by_current : 0.0);
      loop.slow_stiffness = by_station;
      loop.low_frequency_period = hull.low_frequency_period;
      mode.loop = positioned_swing(data, k, mass, omega, loop);
    }
  }
  return modes;
}

}  // namespace overbend
