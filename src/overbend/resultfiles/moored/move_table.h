/// The places of a pull-ahead as a table of text.
#pragma once

#include <string>

#include "results/mooring_results.h"

namespace overbend {

/// The text of pull_ahead.csv: a row per place with the hull, lengths and tensions of all lines and, where there is
/// one, the pipe; engineering units.
std::string move_table(const MooringResults& results);

}  // namespace overbend
