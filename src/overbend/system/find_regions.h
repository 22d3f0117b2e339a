/// Finds the boundaries of overbend, sagbend and seabed, in statics and in dynamics.
#pragma once

#include <optional>
#include <span>

#include "results/regions.h"

namespace overbend {

/// Bending along a line, from the anchor to the tensioner; arrays of equal length.
struct BendingProfile {
  std::span<const double> s;         ///< Arc length from the anchor [m].
  std::span<const double> moment;    ///< Magnitude [N m].
  std::span<const double> vertical;  ///< Component in the vertical plane, sagging positive [N m].
};

/// Returns the regions. `departure`: arc length of the last contact with a support, empty if no support carries.
/// `clamped`: the guide holds the pipe's direction. Below a support the pipe hogs down to its inflection point. Without
/// a support the moment of a clamped guide decays to its first minimum; a pipe that can rotate in its guide has no such
/// section.
Regions find_regions(const BendingProfile& line, double touchdown, std::optional<double> departure, bool clamped);

}  // namespace overbend
