/// Finds where overbend, sagbend and seabed meet, in statics and at an instant of a time-domain run alike.
#pragma once

#include <optional>
#include <span>

#include "results/regions.h"

namespace overbend {

/// Bending along a line, from the anchor to the tensioner; arrays of one length.
struct BendingProfile {
  std::span<const double> s;         ///< Arc length from the anchor [m].
  std::span<const double> moment;    ///< Magnitude [N m].
  std::span<const double> vertical;  ///< Part in the vertical plane, sagging positive [N m].
};

/// `departure`: arc length of the last contact with a support, none where no support carries. `clamped`: the guide
/// holds the pipe's direction. Below a support the pipe hogs to its inflection: the first place that sags. Without a
/// support the moment of a clamped guide dies away to the first place where the moment is least; a pipe that may turn
/// in its guide has no such stretch.
Regions find_regions(const BendingProfile& line, double touchdown, std::optional<double> departure, bool clamped);

}  // namespace overbend
