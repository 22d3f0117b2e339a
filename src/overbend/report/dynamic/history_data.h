/// Histories and spectra for the figures.
#pragma once

#include "base/json.h"
#include "report/page/quantity.h"
#include "results/dynamic_results.h"

namespace overbend {

/// Low and high of each stretch as whole numbers between 0 and 4095, to be scaled by `quantum` and shifted by `lowest`;
/// null where they are not finite. Null where none is.
Json history_trace(const HistorySummary& history, const Quantity& q);

/// The histories that the report shows, each with the group it is drawn in: "wave", "motions", "tension", "stress",
/// "reactions" (of the supports pressed hardest), "separation", "offset", "moorings" or, in a pull-ahead, "operation".
/// Values as in history_trace().
Json history_data(const StaticResults& statics, const DynamicResults& results);

/// Spectra up to the frequency below which nearly all variance lies; none of what moves less than can be read.
Json spectrum_data(const DynamicResults& results);

}  // namespace overbend
