/// Contribution of the steady current to the load effects of the static state: an environmental load in DNV.
#pragma once

#include "base/vec.h"
#include "results/static_results.h"

namespace overbend {

/// Contribution at a position on the line; zero if the static results do not separate it.
struct CurrentPart {
  double vertical = 0.0, lateral = 0.0;  ///< Bending moment in and normal to the pipe's vertical plane [N m].
  double tension = 0.0;                  ///< Effective tension [N].

  /// Returns the moment as a vector in W for a pipe with the unit tangent `t` [N m].
  Vec3 moment(const Vec3& t) const;
};

/// Interpolates linearly between stations; `s` from the anchor [m].
CurrentPart current_part(const StaticResults& statics, double s);

/// True if the static results separate the contribution of the current.
bool has_current_part(const StaticResults& statics);

}  // namespace overbend
