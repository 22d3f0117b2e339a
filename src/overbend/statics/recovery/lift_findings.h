/// Findings on a stage of a lift.
#pragma once

#include "base/assumption.h"
#include "base/finding.h"
#include "model/model.h"
#include "results/lift_results.h"
#include "results/line_results.h"

namespace overbend {

/// Warns of ends drawn back, inclined or slack wires, pipe that yields at a davit, and welded lines in compression.
void warn_of_lift(const Model& model, const LiftResults& lift, Findings& findings);

/// Warns of lines beyond their breaking load and of slack straight wires between bodies. `lines`: in the order of the
/// model.
void warn_of_wires(const Model& model, const std::vector<LineResult>& lines, Findings& findings);

/// Assumptions on lifted lines, as sentences for the report.
Assumptions lift_assumptions(const Model& model);

}  // namespace overbend
