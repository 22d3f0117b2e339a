/// Results of a case that a study gathers, by the names that they have in summary.json.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/json.h"
#include "model/description/description.h"
#include "model/description/study_description.h"
#include "results/study_results.h"

namespace overbend {

/// The output of that name with its unit; nothing where an analysis of this kind has no such result. Of a value over
/// time, a group of min, max, mean and std, the name of the group stands for its largest value (its smallest where the
/// name says so: dynamic.smallest_tension). Of an operation the names are those of its worst stage, and
/// operation.stages[...] stands before those of other stages. Of a goal `seek` what it tells of itself: seek.residual,
/// seek.evaluations, and with one key seek.answer and seek.slope.
std::optional<StudyOutput> study_output(StudyAnalysis analysis, const std::string& name,
                                        const std::optional<SeekDescription>& seek = {});

/// The known path that is nearest to what was meant; empty where none is near.
std::string nearest_output(StudyAnalysis analysis, const std::string& name);

/// What is gathered of a model, of which a study does not say it: of a lay, of a hull on mooring lines, of lines by
/// themselves.
std::vector<std::string> usual_outputs(StudyAnalysis analysis, const Description& model);

/// The value of an output [SI]; nothing where the summary has none.
std::optional<double> output_value(const Json& summary, StudyAnalysis analysis, const std::string& name);

}  // namespace overbend
