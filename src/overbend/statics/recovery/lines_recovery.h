/// Results of lines in static equilibrium.
#pragma once

#include "base/assumption.h"
#include "base/finding.h"
#include "results/line_results.h"
#include "statics/solver/lines_setup.h"

namespace overbend {

/// Returns the results of all lines. `assembly`: evaluated at the state of the lines, as by rest_lines(). `findings`
/// receives lines that are slack, loaded beyond their breaking load, or lift an end fixed to the bed.
std::vector<LineResult> recover_lines(const Model& model, const Assembly& assembly, const StaticLines& lines,
                                      Findings& findings);

/// Results of one line with its shape, without warnings.
LineResult recover_line_result(const FreeLineDescription& description, const LineAssembly& solved,
                               const std::vector<double>& q);

/// Length supported by the bed: half of an element for each of its nodes in contact [m]. `q` as LineState::q.
double length_on_bed(const Line& line, const std::vector<double>& q);

/// Assumptions on the lines, as sentences for the report.
Assumptions line_assumptions(const Model& model);

}  // namespace overbend
