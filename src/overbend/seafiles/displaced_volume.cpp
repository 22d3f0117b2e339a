#include "seafiles/displaced_volume.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/constants.h"
#include "model/waves/wave_theory.h"

namespace overbend {
namespace {

constexpr double kAlong = 1.0 * kDegree;  // angle between a heading and the hull's axis
constexpr double kMaxPhase = 0.6;         // k L / 2: half the hull length is a tenth of the wave length

/// Returns the index of a heading along the hull.
std::optional<std::size_t> along_hull(const std::vector<double>& headings) {
  for (std::size_t j = 0; j < headings.size(); ++j) {
    if (std::abs(std::sin(headings[j])) < std::sin(kAlong)) return j;
  }
  return std::nullopt;
}

/// Returns the water acceleration averaged over length and draught, per wave amplitude [1/s2].
double mean_acceleration(double k, double gravity, const HullSize& hull) {
  const double half = 0.5 * k * hull.length, deep = k * hull.depth;
  const double draught = std::min(hull.draught, hull.depth), kt = k * draught;
  // (sinh kd - sinh k(d-T)) / (kT cosh kd), without overflow
  const double lower = std::exp(-kt) * (1.0 - std::exp(-2.0 * (deep - kt))) / (1.0 + std::exp(-2.0 * deep));
  const double orbit = kt > 0.0 ? (std::tanh(deep) - lower) / kt : 1.0;
  return gravity * k * orbit * std::sin(half) / half;
}

double surge_added_mass(const HydrodynamicData& data, double omega) {
  const auto nearest = std::min_element(data.radiation.begin(), data.radiation.end(),
                                        [&](const RadiationPoint& a, const RadiationPoint& b) {
                                          return std::abs(a.omega - omega) < std::abs(b.omega - omega);
                                        });
  return nearest->added_mass(0, 0);
}

}  // namespace

std::optional<VolumeEstimate> displaced_volume(const HydrodynamicData& data, const HullSize& hull) {
  const auto heading = along_hull(data.excitation.heading);
  if (!heading || data.excitation.omega.size() < 2 || data.radiation.empty()) return std::nullopt;
  std::array<double, 2> volumes{}, k{};
  for (std::size_t i = 0; i < 2; ++i) {
    const double omega = data.excitation.omega[i];
    k[i] = linear_wave_number(omega, hull.depth);
    if (0.5 * k[i] * hull.length > kMaxPhase) return std::nullopt;
    const double force = std::abs(data.force[data.excitation.index(i, *heading)](0));
    const double mass = force / mean_acceleration(k[i], data.gravity, hull) - surge_added_mass(data, omega);
    volumes[i] = mass / data.water_density;
  }
  const double step = (volumes[0] - volumes[1]) * k[0] * k[0] / (k[1] * k[1] - k[0] * k[0]);
  const double volume = volumes[0] + step;
  if (!(volumes[0] > 0.0) || !(volume > 0.0)) return std::nullopt;
  return VolumeEstimate{volume, std::abs(step) / volume};
}

}  // namespace overbend
