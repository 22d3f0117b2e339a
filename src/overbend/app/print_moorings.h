/// Text of hull and moorings for the terminal.
#pragma once

#include <string>

#include "results/dynamic_results.h"

namespace overbend {

/// Returns the static position of the hull and the state of its lines, initially and for each stage.
std::string moored_state_lines(const MooringResults& results);

/// Returns the damping ratios of the low-frequency motions and the accuracy of the radiation model.
std::string hull_lines(const HullResults& hull);

/// Returns statistics of vessel motions and line tensions; empty if the vessel does not float freely.
std::string moored_dynamics_lines(const DynamicResults& results);

}  // namespace overbend
