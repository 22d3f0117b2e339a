/// Strains of a line at the points of its internal damping. The dissipation in a step depends on the strain change:
/// rates of vibrations faster than the steps contain no information on the path between them.
#pragma once

#include <vector>

#include "mechanics/line_elements.h"

namespace overbend {

struct StrainPoint {
  double strain = 0.0;
  double damping = 0.0;  ///< Damping force times the length represented by the point [N m].
  double power = 0.0;    ///< Instantaneous power dissipated by damping [W].
};

/// Appends the points of the damped elements, three each. `q`, `v`: six per node.
void add_strain_points(const LineElements& elements, const double* q, const double* v,
                       std::vector<StrainPoint>& points);

}  // namespace overbend
