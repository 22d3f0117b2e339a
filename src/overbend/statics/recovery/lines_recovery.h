/// From the shapes of lines at rest to what is told of them.
#pragma once

#include "base/assumption.h"
#include "base/finding.h"
#include "results/line_results.h"
#include "statics/solver/lines_setup.h"

namespace overbend {

/// `assembly` stands evaluated at the state of the lines, as rest_lines() leaves it. `findings` receives lines that are
/// slack, loaded beyond their breaking load, or pulled up at an end that stands on the bed.
std::vector<LineResult> recover_lines(const Model& model, const Assembly& assembly, const LinesAtRest& lines,
                                      Findings& findings);

/// One line with its shape, without warnings.
LineResult recover_line_result(const FreeLineDescription& description, const LineAssembly& solved,
                               const std::vector<double>& q);

/// Length that the bed bears: half of an element for each of its nodes that touches it [m]. `q` as LineState::q.
double length_on_bed(const Line& line, const std::vector<double>& q);

/// What had to be assumed of the lines: sentences for the report.
Assumptions line_assumptions(const Model& model);

}  // namespace overbend
