/// Hull and moorings at rest as lines on the terminal.
#pragma once

#include <string>

#include "results/mooring_results.h"

namespace overbend {

std::string mooring_lines(const MooringResults& results);

/// The same without title and warnings.
std::string moored_state_lines(const MooringResults& results);

}  // namespace overbend
