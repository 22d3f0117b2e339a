/// What is made of a run's histories when it ends.
#pragma once

#include "results/dynamic_results.h"
#include "runstore/run_store.h"

namespace overbend {

/// Fills histories, spectra and extremes, one column at a time.
void finish_histories(DynamicResults& results, const RunStore& store);

}  // namespace overbend
