/// Places for the report's figures, with their captions; scripts of the page draw into them.
#pragma once

#include <string>

#include "results/dynamic_results.h"

namespace overbend {

/// HTML of all figures that make sense for these results: without supports there is no overbend to show. `number` is
/// that of the figure before, and then that of the last.
std::string figures_section(const StaticResults& results, const std::string& id, const std::string& heading,
                            int& number);

/// Likewise of a dynamic run: envelopes, histories, spectra, contacts.
std::string dynamic_figures_section(const StaticResults& statics, const DynamicResults& results, int& number);

}  // namespace overbend
