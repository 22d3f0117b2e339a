/// Histories and spectra for the figures.
#pragma once

#include "base/json.h"
#include "report/page/quantity.h"
#include "results/dynamic_results.h"

namespace overbend {

/// Returns minimum and maximum of each interval as integers from 0 to 4095, to be multiplied by `quantum` and added to
/// `lowest`; null for values that are not finite. Null if there are none.
Json history_trace(const HistorySummary& history, const Quantity& q);

/// Returns the histories of the report, each with its figure group: "wave", "motions", "tension", "stress", "reactions"
/// (of the supports with the largest reactions), "separation", "offset", "moorings" or, in a pull-ahead, "operation".
/// Values as in history_trace().
Json history_data(const StaticResults& statics, const DynamicResults& results);

/// Returns spectra up to the frequency that contains nearly all variance; none for quantities with negligible
/// variation.
Json spectrum_data(const DynamicResults& results);

}  // namespace overbend
