/// Low-frequency and wave-frequency parts of a floating vessel's motion and of line tensions, after a run.
#pragma once

#include "model/description/description.h"
#include "model/site/wave_groups.h"
#include "results/dynamic_results.h"
#include "runstore/run_store.h"

namespace overbend {

/// Period that separates low-frequency motion from waves [s]: 10 % longer than the period beyond which 0.1 % of the
/// sea's variance lies, or 1.6 times the period of a regular wave, but at least 20 s; of several groups of waves the
/// longest.
double cut_off_period(const WaveGroups& groups);

/// Fills the low-frequency (slow) and wave parts, most probable extremes and numbers of cycles of `results.vessel` and
/// `results.moorings` from the columns of the run, and adds the slow parts as columns: `vessel/slow_surge` for
/// `vessel/surge`. Minimum distances of the lines to seabed objects are those of the snapshots. Warns of runs that are
/// too short for slow motions. Does nothing if the vessel does not float.
void finish_motions(const StaticResults& statics, const Description& description, DynamicResults& results,
                    RunStore& store);

}  // namespace overbend
