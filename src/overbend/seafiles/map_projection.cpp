#include "seafiles/map_projection.h"

#include <cmath>

namespace overbend {
namespace {

/// Geocentric coordinates [m].
struct Geocentric {
  double x, y, z;
};

Geocentric geocentric(double lat, double lon) {
  constexpr double kSemiAxis = 6378137.0, kFlattening = 1.0 / 298.257223563;
  constexpr double kSquaredEccentricity = kFlattening * (2.0 - kFlattening);
  const double sine = std::sin(lat), radius = kSemiAxis / std::sqrt(1.0 - kSquaredEccentricity * sine * sine);
  return {radius * std::cos(lat) * std::cos(lon), radius * std::cos(lat) * std::sin(lon),
          radius * (1.0 - kSquaredEccentricity) * sine};
}

}  // namespace

PlanPoint tangent_plane_point(double lat, double lon, double origin_lat, double origin_lon) {
  const Geocentric point = geocentric(lat, lon - origin_lon), origin = geocentric(origin_lat, 0.0);
  const double dx = point.x - origin.x, dz = point.z - origin.z;
  return {point.y, std::cos(origin_lat) * dz - std::sin(origin_lat) * dx};
}

void turn_depths(Bathymetry& depths, double azimuth) {
  if (azimuth == 0.0) return;
  const double sine = std::sin(azimuth), cosine = std::cos(azimuth);
  for (std::size_t i = 0; i < depths.depth.size(); ++i) {
    const double east = depths.east[i], north = depths.north[i];
    depths.east[i] = cosine * east - sine * north;
    depths.north[i] = sine * east + cosine * north;
  }
  depths.columns = depths.rows = 0;
}

}  // namespace overbend
