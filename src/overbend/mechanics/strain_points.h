/// Strains of a line where its internal damping acts: what that takes in a step goes by how far they change, since
/// rates of vibrations faster than the steps tell nothing of the way between them.
#pragma once

#include <vector>

#include "mechanics/line_elements.h"

namespace overbend {

struct StrainPoint {
  double strain = 0.0;
  double damping = 0.0;  ///< Force by damping, times the length that the point stands for [N m].
  double power = 0.0;    ///< That damping takes at the instant [W].
};

/// Appends the points of the elements that are damped, three each. `q`, `v`: six per node.
void add_strain_points(const LineElements& elements, const double* q, const double* v,
                       std::vector<StrainPoint>& points);

}  // namespace overbend
