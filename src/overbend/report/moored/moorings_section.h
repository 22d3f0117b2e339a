/// The sections on mooring lines at rest: words and tables. Each returns HTML; empty where there is nothing to say.
#pragma once

#include <string>

#include "results/mooring_results.h"

namespace overbend {

/// Tiles, plan, table of lines, profiles and where the hull lies. `figure` is counted on.
std::string moorings_section(const MooringResults& results, int& figure);

/// The stages of the operation; what winches do and the pipe has in a pull-ahead; where anchors go
/// (operation_section.cpp).
std::string operation_section(const MooringResults& results, int& figure);

/// "port bow 346.6 kN": the line that pulls hardest; empty without a line that pulls.
const MooringLineResult* hardest_line(const MooredState& state);

}  // namespace overbend
