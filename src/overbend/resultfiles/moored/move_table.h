/// The positions of a pull-ahead as a text table.
#pragma once

#include <string>

#include "results/mooring_results.h"

namespace overbend {

/// Returns the text of pull_ahead.csv: a row per position with the hull, lengths and tensions of all lines and, if
/// present, the pipe; engineering units.
std::string move_table(const MooringResults& results);

}  // namespace overbend
