/// Data for the figures of a dynamic run.
#pragma once

#include "base/json.h"
#include "results/dynamic_results.h"

namespace overbend {

/// Returns envelopes as columns from the tensioner to the anchor (SI), histories and spectra in the units of
/// report/page/quantity.h, contacts and impacts. Only the data that the figures show: of all supports those with the
/// largest reactions. Without a pipe: histories, spectra and vessel positions.
Json dynamic_figure_data(const StaticResults& statics, const DynamicResults& results);

}  // namespace overbend
