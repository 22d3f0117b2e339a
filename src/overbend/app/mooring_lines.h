/// Hull and moorings at rest as lines on the terminal.
#pragma once

#include <string>

#include "results/dynamic_results.h"

namespace overbend {

/// Where the hull lies and its lines, at rest and stage by stage.
std::string moored_state_lines(const MooringResults& results);

/// Damping ratios of the slow motions and how well the fit represents the radiation.
std::string hull_lines(const HullResults& hull);

/// Where the vessel was and what its lines had; empty where it does not float.
std::string moored_dynamics_lines(const DynamicResults& results);

}  // namespace overbend
