/// What an engineer would want to be told of a stage of a lift.
#pragma once

#include "base/assumption.h"
#include "base/finding.h"
#include "model/model.h"
#include "results/lift_results.h"
#include "results/line_results.h"

namespace overbend {

/// Ends drawn back, wires that lean or are slack, pipe that yields at a davit, welded lines that are pushed.
void warn_of_lift(const Model& model, const LiftResults& lift, Findings& findings);

/// Lines beyond their breaking load, and straight wires between bodies that are slack. `lines` in the order of the
/// model.
void warn_of_wires(const Model& model, const std::vector<LineResult>& lines, Findings& findings);

/// What had to be assumed: sentences for the report.
Assumptions lift_assumptions(const Model& model);

}  // namespace overbend
