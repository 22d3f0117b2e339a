/// The report's figures with their captions, drawn by the page.
#pragma once

#include <string>

#include "report/page/blocks.h"
#include "results/dynamic_results.h"

namespace overbend {

/// Returns all figures that apply to these results: without supports there is no overbend to show.
Blocks figures_section(const StaticResults& results, const std::string& id, const std::string& heading);

/// Returns the same for a dynamic run: envelopes, histories, spectra, contacts.
Blocks dynamic_figures_section(const StaticResults& statics, const DynamicResults& results);

}  // namespace overbend
