/// Vessel and mooring lines over time: tables of slow and wave parts. HTML.
#pragma once

#include <string>

#include "results/dynamic_results.h"

namespace overbend {

/// Nothing where the hull is not free and no line was followed. `figure` is counted on.
std::string moored_dynamics_section(const DynamicResults& results, int& figure);

}  // namespace overbend
