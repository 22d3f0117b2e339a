/// The report's figures with their captions, which the page draws.
#pragma once

#include <string>

#include "report/page/blocks.h"
#include "results/dynamic_results.h"

namespace overbend {

/// All figures that make sense for these results: without supports there is no overbend to show.
Blocks figures_section(const StaticResults& results, const std::string& id, const std::string& heading);

/// Likewise of a dynamic run: envelopes, histories, spectra, contacts.
Blocks dynamic_figures_section(const StaticResults& statics, const DynamicResults& results);

}  // namespace overbend
