/// What the assumption on the loading history of yielding steel decides (analysis.static.history).
#pragma once

#include "statics/solver/statics.h"

namespace overbend {

/// Where pipe has yielded: solves the same lay with the other loading history, starting from `solution`, and says in
/// `results` which strain each of them gives in the overbend and beside structures; a warning where they differ by more
/// than 5 %, an assumption otherwise. Does nothing for a stage whose steel has a history of its own.
void note_history_effect(const Model& model, const StaticSolution& solution, StaticResults& results);

}  // namespace overbend
