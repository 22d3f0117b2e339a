/// From the shapes of lines at rest to what is told of them.
#pragma once

#include "base/assumption.h"
#include "results/line_results.h"
#include "statics/solver/lines_setup.h"

namespace overbend {

/// `assembly` stands evaluated at `state`, as rest_lines() leaves it. Warns of lines that are slack, loaded beyond
/// their breaking load, or pulled up at an end that stands on the bed.
LinesResults recover_lines(const Model& model, const Assembly& assembly, const SystemState& state,
                           const LinesRest& rest);

/// Length that the bed bears: half of an element for each of its nodes that touches it [m]. `q` as LineState::q.
double length_on_bed(const Line& line, const std::vector<double>& q);

/// What had to be assumed of the lines: sentences for the report.
Assumptions line_assumptions(const Model& model);

}  // namespace overbend
