/// Where the line meets the seabed.
#pragma once

#include <optional>

#include "statics/equations/static_system.h"

namespace overbend {

/// A place along the line.
struct ElementPlace {
  int element = 0;
  double xi = 0.0;
  double s = 0.0;  ///< From the anchor [m].
};

/// Clear height of the pipe's underside over the bed, along the bed's normal [m].
double bed_clearance(const StaticSystem& system, const LineState& state, int element, double xi);

/// First place from the tensioner where the underside reaches the bed; none when it never does.
std::optional<ElementPlace> find_touchdown(const StaticSystem& system, const LineState& state);

/// The same; where the line ends at an anchor before it touches the bed, its end.
std::optional<ElementPlace> landing(const StaticSystem& system, const LineState& state);

/// First place from the tensioner where the axis goes under water, none when it starts there or never does.
std::optional<ElementPlace> find_waterline(const StaticSystem& system, const LineState& state);

}  // namespace overbend
