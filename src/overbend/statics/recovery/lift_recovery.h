/// From lines that hold each other, at rest, to what is told of them.
#pragma once

#include "results/lift_results.h"
#include "results/line_results.h"
#include "statics/solver/linked_lines.h"

namespace overbend {

/// Of the position that the lines are in. `next`: the weld that is still to be made, or null.
LiftResults recover_lift(const Model& model, const LinkedLines& lines, const JoinDescription* next);

/// All of them in the words of lines by themselves.
std::vector<LineResult> recover_linked_lines(const Model& model, const LinkedLines& lines);

}  // namespace overbend
