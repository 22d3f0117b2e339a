/// What in a static state or its model calls for a second look, in words: results.findings.
#pragma once

#include <string>
#include <vector>

#include "base/finding.h"
#include "model/model.h"
#include "results/static_results.h"

namespace overbend {

/// Slack pipe, stress past yield of linear steel, supports that stand where none can: below the bed, below the water,
/// proud of their neighbours; strain at field joints that nobody told; a slope on which friction does not hold what is
/// laid. Appended to `results.findings`.
void warn_statics(const Model& model, StaticResults& results);

/// Those of them that the model alone gives, in its pose.
Findings lay_findings(const Model& model);

/// A place along the pipe for a sentence: "at 12.3 m from the tensioner (overbend)".
std::string pipe_place(const StaticResults& results, double s);

}  // namespace overbend
