/// Data of the figures of a dynamic run.
#pragma once

#include "base/json.h"
#include "results/dynamic_results.h"

namespace overbend {

/// Envelopes as columns from the tensioner to the anchor (SI), histories and spectra in the units of
/// report/page/quantity.h, contacts and impacts. Only what the figures show: of all supports the hardest pressed.
/// Without a pipe histories, spectra and where the vessel was.
Json dynamic_figure_data(const StaticResults& statics, const DynamicResults& results);

}  // namespace overbend
