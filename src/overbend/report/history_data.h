/// Histories and spectra for the figures.
#pragma once

#include <nlohmann/json.hpp>

#include "report/quantity.h"
#include "results/dynamic_results.h"

namespace overbend {

/// Low and high of each stretch as whole numbers between 0 and 4095, to be scaled by `quantum` and shifted by `lowest`;
/// null where they are not finite. Null where none is.
nlohmann::json history_trace(const HistorySummary& history, const Quantity& q);

/// The histories that the report shows, each with the group it is drawn in: "wave", "motions", "tension", "stress",
/// "reactions" (of the supports pressed hardest), "separation", "offset", "moorings" or, in a pull-ahead, "operation".
/// Values as in history_trace().
nlohmann::json history_data(const StaticResults& statics, const DynamicResults& results);

/// Spectra up to the frequency below which nearly all variance lies; none of what moves less than can be read.
nlohmann::json spectrum_data(const DynamicResults& results);

}  // namespace overbend
