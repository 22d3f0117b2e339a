/// What is made of a run's histories when it ends.
#pragma once

#include "model/description/description.h"
#include "results/dynamic_results.h"
#include "runstore/run_store.h"

namespace overbend {

/// Fills histories, spectra and extremes, one column at a time, and warns of what they show.
void finish_histories(const Description& description, DynamicResults& results, const RunStore& store);

}  // namespace overbend
