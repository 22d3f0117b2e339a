/// Places for the report's figures, with their captions; scripts of the page draw into them.
#pragma once

#include <string>

#include "results/static_results.h"

namespace overbend {

/// HTML of all figures that make sense for these results: without supports there is no overbend to show.
std::string figures_section(const StaticResults& results);

}  // namespace overbend
