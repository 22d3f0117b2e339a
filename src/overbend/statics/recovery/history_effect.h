/// Effect of the assumed loading history of yielding steel (analysis.static.history).
#pragma once

#include "statics/solver/statics.h"

namespace overbend {

/// If the pipe has yielded: solves the same lay with the other loading history, with a warm start from `solution`, and
/// reports in `results` the strain with each history in the overbend and next to structures: a warning if they differ
/// by more than 5 %, an assumption otherwise. Does nothing for a stage whose steel has its own history.
void note_history_effect(const Model& model, const StaticSolution& solution, StaticResults& results);

}  // namespace overbend
