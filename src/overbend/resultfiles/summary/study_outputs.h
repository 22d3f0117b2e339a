/// Results of a case that a study collects, by their names in summary.json.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/json.h"
#include "model/description/description.h"
#include "model/description/study_description.h"
#include "results/study_results.h"

namespace overbend {

/// Returns the output of that name with its unit; nothing if an analysis of this kind has no such result. For a value
/// over time, a group of min, max, mean and std, the name of the group stands for its maximum (its minimum if the name
/// says so: dynamic.min_effective_tension). For an operation the names are those of its worst stage, and
/// operation.stages[...] is the prefix for those of other stages. For a goal seek `seek` its own outputs:
/// seek.residual, seek.evaluations, and with one key seek.answer and seek.slope.
std::optional<StudyOutput> study_output(StudyAnalysis analysis, const std::string& name,
                                        const std::optional<SeekDescription>& seek = {});

/// Returns the known path closest to a misspelt one; empty if none is close.
std::string nearest_output(StudyAnalysis analysis, const std::string& name);

/// Returns the default outputs of a model if the study gives none: of a lay, of a hull on mooring lines, of stand-alone
/// lines.
std::vector<std::string> default_outputs(StudyAnalysis analysis, const Description& model);

/// Returns the value of an output [SI]; nothing if the summary has none.
std::optional<double> output_value(const Json& summary, StudyAnalysis analysis, const std::string& name);

}  // namespace overbend
