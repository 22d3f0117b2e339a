/// Coordinates of maps in the frame of the model: position, rotation, and degrees in a tangent plane.
#pragma once

#include "model/description/seabed_description.h"

namespace overbend {

/// Position in a plane [m].
struct PlanPoint {
  double east = 0.0, north = 0.0;
};

/// Returns the position of a point of the ellipsoid of WGS 84 in the plane that touches it at the origin; angles are
/// geodetic [rad]. Geographic to topocentric conversion, IOGP guidance note 7-2, EPSG method 9837, without heights;
/// a = 6378137 m, 1/f = 298.257223563.
PlanPoint tangent_plane_point(double lat, double lon, double origin_lat, double origin_lon);

/// Turns depths from the axes of a map, about its origin, into those of the model, whose north has this azimuth in the
/// map [rad]. A grid that is turned becomes scattered points.
void turn_depths(Bathymetry& depths, double azimuth);

}  // namespace overbend
