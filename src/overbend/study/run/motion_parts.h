/// Slow and wave part of a floating vessel's motion and of its lines' tensions, when a run has ended.
#pragma once

#include "model/description/description.h"
#include "results/dynamic_results.h"
#include "runstore/run_store.h"

namespace overbend {

/// Period that parts slow motion from waves [s]: a tenth longer than that beyond which a thousandth of the sea's
/// variance lies, or 1.6 times that of a regular wave, but 20 s at least.
double cut_off_period(const WavesDescription& waves);

/// Fills slow and wave parts, most probable extremes and numbers of cycles of `results.vessel` and `results.moorings`
/// from the columns of the run, and adds the slow parts as columns: `vessel/slow_surge` for `vessel/surge`. Least
/// distances of the lines to the objects on the bed are those of the snapshots. Warns of runs that are too short for
/// the slow motions. Nothing where the vessel does not float.
void finish_motions(const StaticResults& statics, const Description& description, DynamicResults& results,
                    RunStore& store);

}  // namespace overbend
