/// Results of lines attached to each other, in static equilibrium.
#pragma once

#include "results/lift_results.h"
#include "results/line_results.h"
#include "statics/solver/linked_lines.h"

namespace overbend {

/// Results of the present position of the lines. `next`: weld that is still to be made, or null.
LiftResults recover_lift(const Model& model, const LinkedLines& lines, const JoinDescription* next);

/// Results of all lines in the form of separate lines.
std::vector<LineResult> recover_linked_lines(const Model& model, const LinkedLines& lines);

}  // namespace overbend
