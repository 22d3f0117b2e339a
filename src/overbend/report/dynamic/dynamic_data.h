/// Data of the figures of a dynamic run.
#pragma once

#include "base/json.h"
#include "results/dynamic_results.h"

namespace overbend {

/// Envelopes as columns from the tensioner to the anchor (SI), histories and spectra in the units of
/// report/page/quantity.h, contacts and impacts. Only what the figures show: of all supports the hardest pressed.
Json dynamic_figure_data(const StaticResults& statics, const DynamicResults& results);

/// Of a hull on its mooring lines without a pipe: histories, spectra, where the vessel was.
Json moored_figure_data(const MooringResults& rest, const DynamicResults& results);

}  // namespace overbend
