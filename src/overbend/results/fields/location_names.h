/// Positions in the vessel's axes, as used on board.
#pragma once

#include <optional>
#include <string>

#include "results/static_results.h"

namespace overbend {

/// Returns X astern of the stern shoe, Y to port of the vessel's centre plane, both horizontal; Z above the mean water
/// level [m].
Vec3 ship_point(const StaticResults& results, const Vec3& p_W);

/// Returns midship on the water line of the vessel: shifted from the nominal position if mooring lines hold the vessel.
/// Frame W [m].
Vec3 midship(const StaticResults& results);

/// Returns a direction in the same axes.
Vec3 ship_direction(const StaticResults& results, const Vec3& d_W);

/// Returns the pipe at arc length s [m] from the anchor, linear between stations; constant beyond the ends.
Station station_at(const StaticResults& results, double s);

/// Returns the distance along the pipe from the tensioner [m]; `s` is the arc length from the anchor [m].
double from_tensioner(const StaticResults& results, double s);

/// Returns a stress [Pa] at arc length s [m] from the anchor in percent of the yield stress there; 0 if no yield stress
/// is known.
double yield_percent(const StaticResults& results, double s, double stress);

/// Returns the name of the box over arc length s [m], or "between A and B", "tensioner" side and the like; "sagbend",
/// "seabed" beyond.
std::string location_name(const StaticResults& results, double s);
/// Returns the same for a check; for a check outside the laid pipe its own text on the position.
std::string location_name(const StaticResults& results, const CheckRow& row);
/// Returns the distance of a check from the tensioner [m]; nothing for a check outside the laid pipe.
std::optional<double> along_pipe(const StaticResults& results, const CheckRow& row);

}  // namespace overbend
