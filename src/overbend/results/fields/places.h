/// Where things are, in the axes that people aboard use.
#pragma once

#include <optional>
#include <string>

#include "results/static_results.h"

namespace overbend {

/// X astern of the stern shoe, Y to port of the vessel's centre plane, both horizontal; Z above the mean water level
/// [m].
Vec3 ship_point(const StaticResults& results, const Vec3& p_W);

/// Midship on the water line where the vessel lies: shifted from the drawn place where mooring lines hold it. Frame W
/// [m].
Vec3 midship(const StaticResults& results);

/// The same axes, of a direction.
Vec3 ship_direction(const StaticResults& results, const Vec3& d_W);

/// The pipe at arc length s from the anchor, linear between stations; at the ends the end stations.
Station station_at(const StaticResults& results, double s);

/// Distance along the pipe from the tensioner [m].
double from_tensioner(const StaticResults& results, double s);

/// A stress at arc length s from the anchor in percent of the yield stress there; 0 where no yield stress is known.
double yield_percent(const StaticResults& results, double s, double stress);

/// Name of the box whose length holds a place, or "between A and B", "tensioner" side and the like; "sagbend", "seabed"
/// behind.
std::string place_name(const StaticResults& results, double s);
/// The same of a check; of one that is not of the laid pipe what it says of its place.
std::string place_name(const StaticResults& results, const CheckRow& row);
/// Distance of a check from the tensioner; nothing for one that is not of the laid pipe [m].
std::optional<double> along_pipe(const StaticResults& results, const CheckRow& row);

}  // namespace overbend
