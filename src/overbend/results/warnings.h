/// What results warn of, as everybody who shows them tells it.
#pragma once

#include <string>
#include <vector>

#include "results/dynamic_results.h"

namespace overbend {

/// All sentences, then those of `more` that are not among them.
std::vector<std::string> together(std::vector<std::string> all, const std::vector<std::string>& more);

/// Of a static state: of the lay, or of the hull on its moorings where there is no pipe.
const std::vector<std::string>& static_warnings(const StaticResults& results);

/// Of a run in time: its own, then those of the static state that it began from.
std::vector<std::string> all_warnings(const StaticResults& statics, const DynamicResults& results);

}  // namespace overbend
