#include "seafiles/wave_file_content.h"

#include <cmath>
#include <complex>

#include "base/constants.h"
#include "base/units.h"
#include "model/site/sea_statistics.h"

namespace overbend {
namespace {

constexpr double kMaxWaveHeight = 40.0;  ///< Upper limit of the key environment.waves.hs [m].
constexpr double kBreaking = 0.1;        ///< Height over length of mean waves.

/// Returns the sum of the directions of one point as a vector, of unit weight for a single direction.
std::complex<double> direction_vector(const SpectrumDirections& directions, std::size_t point) {
  if (directions.sectors.empty()) return std::polar(1.0, directions.from[point]);
  std::complex<double> sum;
  double total = 0.0;
  const std::size_t count = directions.sectors.size();
  for (std::size_t i = 0; i < count; ++i) {
    const double density = directions.density[point * count + i];
    sum += std::polar(density, directions.sectors[i]);
    total += density;
  }
  return total > 0.0 ? sum / total : sum;
}

}  // namespace

bool check_file_spectrum(const std::vector<SpectrumPoint>& points, const std::string& path, Diagnostics& diagnostics) {
  const auto reject = [&](std::string found, std::string expected) {
    diagnostics.add({Severity::error, path, 0, 0, "", std::move(found), std::move(expected), ""});
    return false;
  };
  if (points.size() < 2) return reject(std::to_string(points.size()) + " frequencies", "at least 2");
  const SeaStatistics sea = sea_statistics(points);
  if (!(sea.hs > 0.0)) return reject("a density of 0 at every frequency", "a spectrum with energy");
  if (sea.hs > kMaxWaveHeight) {
    return reject("a significant wave height of " + format_quantity(sea.hs, "m", "m", 3),
                  "at most " + format_quantity(kMaxWaveHeight, "m", "m"));
  }
  if (kTurn * sea.hs / (kGravity * sea.tz * sea.tz) > kBreaking) {
    diagnostics.add({Severity::warning, path, 0, 0, "",
                     "the sea has " + sea_statistics_label(points) + ", which is steeper than seas that break", "",
                     ""});
  }
  return true;
}

std::optional<double> mean_azimuth(const std::vector<SpectrumPoint>& points, const SpectrumDirections& directions) {
  if (directions.empty()) return std::nullopt;
  std::complex<double> sum;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double below = i > 0 ? points[i].omega - points[i - 1].omega : 0.0;
    const double above = i + 1 < points.size() ? points[i + 1].omega - points[i].omega : 0.0;
    sum += 0.5 * (below + above) * points[i].density * direction_vector(directions, i);
  }
  const double azimuth = std::arg(sum);
  return azimuth < 0.0 ? azimuth + kTurn : azimuth;
}

}  // namespace overbend
