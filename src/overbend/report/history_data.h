/// Histories and spectra for the figures.
#pragma once

#include <nlohmann/json.hpp>

#include "results/dynamic_results.h"

namespace overbend {

/// The histories that the report shows, each with the group it is drawn in: "wave", "motions", "tension", "stress",
/// "reactions" (of the supports pressed hardest) or "separation". Values are whole numbers between 0 and 4095, to be
/// scaled by `quantum` and shifted by `lowest`; null where they are not finite.
nlohmann::json history_data(const StaticResults& statics, const DynamicResults& results);

/// Spectra up to the frequency below which nearly all variance lies; none of what moves less than can be read.
nlohmann::json spectrum_data(const DynamicResults& results);

}  // namespace overbend
