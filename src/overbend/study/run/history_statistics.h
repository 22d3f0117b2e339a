/// Post-processing of the histories of a finished run.
#pragma once

#include "model/description/description.h"
#include "results/dynamic_results.h"
#include "runstore/run_store.h"

namespace overbend {

/// Fills histories, spectra and extremes, one column at a time, and adds the warnings that follow from them.
void finish_histories(const Description& description, DynamicResults& results, const RunStore& store);

}  // namespace overbend
