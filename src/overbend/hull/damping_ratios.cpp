#include "hull/damping_ratios.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

#include "hull/make_radiation.h"
#include "model/rao_table.h"

namespace overbend {
namespace {

/// Force on the slow motion out of phase, over the velocity: the filter delays place and rate alike.
double damping_by_slow_motion(double stiffness, double damping, double omega, double slow_period) {
  const std::complex<double> s(0.0, omega);
  const double w = 2.0 * std::numbers::pi / slow_period;
  const std::complex<double> filter = w * w / ((s + w) * (s + w));
  return (filter * (stiffness + damping * s)).imag() / omega;
}

}  // namespace

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
  // w^2 (m + A(w)) - c is below zero at 0 and above at the frequency that the mass alone would have.
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
    const bool slow = hull.current.form == HullCurrentForm::table;
    mode.current =
        (slow ? damping_by_slow_motion(0.0, by_current, omega, hull.slow_period) : by_current) / mode.critical;
    mode.viscous = hull.damping.linear(k, k) / mode.critical;
    if (hull.station_keeping) {
      const double damping = hull.station_keeping->law.damping(place);
      mode.station_keeping = damping_by_slow_motion(by_station, damping, omega, hull.slow_period) / mode.critical;
    }
  }
  return modes;
}

}  // namespace overbend
