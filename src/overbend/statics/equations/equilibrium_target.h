/// Target of an equilibrium, in place of a given far force.
#pragma once

#include "statics/initial_shape/lay_shape.h"
#include "system/assembly.h"

namespace overbend {

struct EquilibriumTarget {
  enum class Kind { top_tension, anchor_distance } kind = Kind::top_tension;
  double value = 0.0;  ///< Top tension [N], or horizontal distance from the tensioner to the anchor [m].
};

/// Equation of the target for a line laid in `plane`, to first order. The strain at a node is |t| - 1, so that the
/// tension at the tensioner depends on the last node only: EA (|t| - 1) + pressure part.
TargetEquation target_equation(const EquilibriumTarget& target, const LayPlane& plane, const Line& line,
                               const LineState& state);

/// Returns an error of the target relative to its scale: a tension relative to itself or to the line's weight,
/// whichever is smaller; an anchor distance relative to the line's length.
double relative_error(const EquilibriumTarget& target, const Line& line, double error);

}  // namespace overbend
