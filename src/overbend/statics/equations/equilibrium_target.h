/// What an equilibrium aims at, in place of a given far force.
#pragma once

#include "statics/initial_shape/lay_shape.h"
#include "system/assembly.h"

namespace overbend {

struct EquilibriumTarget {
  enum class Kind { top_tension, anchor_distance } kind = Kind::top_tension;
  double value = 0.0;  ///< [N], or horizontal distance from tensioner to anchor [m].
};

/// The target's equation for a line laid in `plane`, to first order. The strain at a node is |t| - 1, so that the
/// tension at the tensioner is one of its last node alone: EA (|t| - 1) + pressure part.
TargetEquation target_equation(const EquilibriumTarget& target, const LayPlane& plane, const Line& line,
                               const LineState& state);

/// An error of the target over its scale: of a tension, over it or the line's weight, whichever is less; of the
/// anchor's distance, over the line's length.
double relative_error(const EquilibriumTarget& target, const Line& line, double error);

}  // namespace overbend
