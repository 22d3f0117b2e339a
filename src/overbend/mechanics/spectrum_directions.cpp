#include "mechanics/spectrum_directions.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <stdexcept>

#include "base/constants.h"
#include "mechanics/sea.h"
#include "mechanics/wave_spreading.h"

namespace overbend {
namespace {

/// Place between two points of a spectrum.
struct Between {
  std::size_t low = 0;
  double share = 0.0;  ///< From `low`, 0, to the next point, 1.

  std::size_t nearest() const { return share < 0.5 ? low : low + 1; }
};

Between find_place(const std::vector<SpectrumPoint>& points, double omega) {
  const auto by_omega = [](double value, const SpectrumPoint& point) { return value < point.omega; };
  const auto above = std::upper_bound(points.begin() + 1, points.end() - 1, omega, by_omega);
  const auto low = static_cast<std::size_t>(above - points.begin()) - 1;
  return {low, std::clamp((omega - points[low].omega) / (points[low + 1].omega - points[low].omega), 0.0, 1.0)};
}

double mean_azimuth(const std::vector<double>& from, const Between& place) {
  const double a = from[place.low], turn = std::remainder(from[place.low + 1] - a, kTurn);
  return a + place.share * turn;
}

/// Draws from densities over sectors, constant within each.
double sector_quantile(const SpectrumDirections& directions, const Between& place, double fraction) {
  const std::size_t count = directions.sectors.size();
  const auto density = [&](std::size_t i) {
    return (1.0 - place.share) * directions.density[place.low * count + i] +
           place.share * directions.density[(place.low + 1) * count + i];
  };
  double total = 0.0;
  for (std::size_t i = 0; i < count; ++i) total += density(i);
  const double width = count > 1 ? directions.sectors[1] - directions.sectors[0] : 0.0;
  double passed = 0.0, wanted = fraction * total;
  for (std::size_t i = 0; i < count; ++i) {
    const double share = density(i);
    if (share > 0.0 && (passed + share >= wanted || i + 1 == count)) {
      return directions.sectors[i] + width * (std::min(1.0, (wanted - passed) / share) - 0.5);
    }
    passed += share;
  }
  return directions.sectors.back();
}

}  // namespace

std::vector<double> component_azimuths(const WavesDescription& waves, std::span<const WaveComponent> components,
                                       Random& random) {
  const SpectrumDirections& directions = waves.directions;
  if (waves.spectrum.size() < 2) throw std::invalid_argument("directions belong to the points of a spectrum");
  const std::vector<double> fractions = shuffled_fractions(static_cast<int>(components.size()), random);
  std::map<double, CosineSpreading> spreadings;  // by exponent: files repeat them
  std::vector<double> azimuths;
  for (std::size_t i = 0; i < components.size(); ++i) {
    const Between place = find_place(waves.spectrum, components[i].omega);
    if (!directions.sectors.empty()) {
      azimuths.push_back(sector_quantile(directions, place, fractions[i]));
      continue;
    }
    double azimuth = mean_azimuth(directions.from, place);
    std::optional<double> s = waves.spreading;
    if (!directions.spreading.empty()) s = directions.spreading[place.nearest()];
    if (s) azimuth += spreadings.try_emplace(*s, *s).first->second.quantile(fractions[i]);
    azimuths.push_back(azimuth);
  }
  return azimuths;
}

}  // namespace overbend
