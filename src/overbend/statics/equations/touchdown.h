/// Touchdown point and waterline of a line.
#pragma once

#include <optional>

#include "statics/equations/static_system.h"

namespace overbend {

/// Place along the line.
struct ElementPlace {
  int element = 0;
  double xi = 0.0;
  double s = 0.0;  ///< Distance from the anchor [m].
};

/// Clearance of the pipe's underside over the bed, along the bed's normal [m].
double bed_clearance(const StaticSystem& system, const LineState& state, int element, double xi);

/// First place from the tensioner at which the underside reaches the bed; nullopt if it never does.
std::optional<ElementPlace> find_touchdown(const StaticSystem& system, const LineState& state);

/// Same; the end of the line if it ends at an anchor before it touches the bed.
std::optional<ElementPlace> landing(const StaticSystem& system, const LineState& state);

/// First place from the tensioner at which the axis goes under water; nullopt if it starts under water or never does.
std::optional<ElementPlace> find_waterline(const StaticSystem& system, const LineState& state);

}  // namespace overbend
