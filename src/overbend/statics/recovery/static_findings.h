/// Warnings of a static analysis: results.findings.
#pragma once

#include <string>
#include <vector>

#include "base/finding.h"
#include "model/model.h"
#include "results/static_results.h"

namespace overbend {

/// Appends to `results.findings`: slack pipe, stress beyond yield of linear steel, implausible supports (below the bed,
/// below the water, out of line with their neighbours), missing strain concentration at field joints, a slope on which
/// friction does not hold the laid pipe.
void warn_statics(const Model& model, StaticResults& results);

/// Findings that follow from the model alone, in its pose.
Findings lay_findings(const Model& model);

/// Label of a place along the pipe: "at 12.3 m from the tensioner (overbend)".
std::string pipe_place(const StaticResults& results, double s);

}  // namespace overbend
